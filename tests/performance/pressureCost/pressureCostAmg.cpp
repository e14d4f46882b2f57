// pressureCostAmg: the pressure by conjugate gradients preconditioned by algebraic multigrid (hypre's BoomerAMG), the
// iterative solver one would take today, against transforms: the same Laplacian, the same random source.
//
//     OMP_NUM_THREADS=1 build/tests/pressureCostAmg             160 x 160 points, both kernels
//     OMP_NUM_THREADS=1 build/tests/pressureCostAmg 80          on others
//     OMP_NUM_THREADS=1 build/tests/pressureCostAmg -test       exits 1 unless all find the same pressure
//
// BoomerAMG is built from the matrix itself, whose rows have a hundred entries and more, and from the five-point
// Laplacian, which is near it and far cheaper to apply; each with several coarsenings, thresholds and smoothers. The
// best of them counts. Seconds are processor time of one thread.

#include "pressureRace.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fmt/format.h>
#include <HYPRE.h>
#include <HYPRE_krylov.h>
#include <HYPRE_parcsr_ls.h>
#include <memory>
#include <mpi.h>
#include <numeric>
#include <vector>

using namespace isph;
using namespace isph::test;

namespace
{

/// hypre's handles are freed by functions.
template<class Handle, HYPRE_Int (*destroy)(Handle)>
class Owned
{
public:
    Owned() = default;
    Owned(const Owned&) = delete;
    Owned& operator=(const Owned&) = delete;
    ~Owned()
    {
        if (handle_ != nullptr) { destroy(handle_); }
    }
    Handle* out() { return &handle_; }
    Handle get() const { return handle_; }

private:
    Handle handle_ = nullptr;
};

class HypreMatrix
{
public:
    /// \param rows entries of each row: columns and values
    explicit HypreMatrix(const SparseMatrix& matrix)
    {
        const auto starts = matrix.rowStarts();
        const auto size = static_cast<HYPRE_Int>(matrix.rows());
        std::vector<HYPRE_BigInt> rows(matrix.rows());
        std::iota(rows.begin(), rows.end(), 0);
        std::vector<HYPRE_Int> counts;
        for (std::size_t i = 0; i < matrix.rows(); ++i) { counts.push_back(starts[i + 1] - starts[i]); }
        const std::vector<HYPRE_BigInt> columns(matrix.columnIndices().begin(), matrix.columnIndices().end());
        HYPRE_IJMatrixCreate(MPI_COMM_WORLD, 0, size - 1, 0, size - 1, matrix_.out());
        HYPRE_IJMatrixSetObjectType(matrix_.get(), HYPRE_PARCSR);
        HYPRE_IJMatrixSetRowSizes(matrix_.get(), counts.data());
        HYPRE_IJMatrixInitialize(matrix_.get());
        HYPRE_IJMatrixSetValues(matrix_.get(), size, counts.data(), rows.data(), columns.data(),
                                matrix.values().data());
        HYPRE_IJMatrixAssemble(matrix_.get());
    }

    HYPRE_ParCSRMatrix get() const
    {
        void* object = nullptr;
        HYPRE_IJMatrixGetObject(matrix_.get(), &object);
        return static_cast<HYPRE_ParCSRMatrix>(object);
    }

private:
    Owned<HYPRE_IJMatrix, HYPRE_IJMatrixDestroy> matrix_;
};

class HypreVector
{
public:
    explicit HypreVector(std::span<const double> values) : rows_(values.size())
    {
        std::iota(rows_.begin(), rows_.end(), 0);
        HYPRE_IJVectorCreate(MPI_COMM_WORLD, 0, static_cast<HYPRE_BigInt>(values.size()) - 1, vector_.out());
        HYPRE_IJVectorSetObjectType(vector_.get(), HYPRE_PARCSR);
        set(values);
    }

    void set(std::span<const double> values)
    {
        HYPRE_IJVectorInitialize(vector_.get());
        HYPRE_IJVectorSetValues(vector_.get(), static_cast<HYPRE_Int>(rows_.size()), rows_.data(), values.data());
        HYPRE_IJVectorAssemble(vector_.get());
    }

    void read(std::span<double> values) const
    {
        HYPRE_IJVectorGetValues(vector_.get(), static_cast<HYPRE_Int>(rows_.size()), rows_.data(), values.data());
    }

    HYPRE_ParVector get() const
    {
        void* object = nullptr;
        HYPRE_IJVectorGetObject(vector_.get(), &object);
        return static_cast<HYPRE_ParVector>(object);
    }

private:
    std::vector<HYPRE_BigInt> rows_;
    Owned<HYPRE_IJVector, HYPRE_IJVectorDestroy> vector_;
};

/// Minus the five-point Laplacian of a periodic square.
SparseMatrix fivePoints(const Lattice& lattice)
{
    const int nx = lattice.axis(0).count;
    const int ny = lattice.axis(1).count;
    const double weight = 1 / (lattice.axis(0).spacing() * lattice.axis(0).spacing());
    AlignedVector<int> starts{0};
    AlignedVector<int> columns;
    AlignedVector<double> values;
    for (int iy = 0; iy < ny; ++iy)
    {
        for (int ix = 0; ix < nx; ++ix)
        {
            const auto at = [nx, ny](int x, int y) { return (x + nx) % nx + nx * ((y + ny) % ny); };
            std::array<int, 5> neighbours{at(ix, iy), at(ix - 1, iy), at(ix + 1, iy), at(ix, iy - 1), at(ix, iy + 1)};
            std::ranges::sort(neighbours);
            for (const int neighbour : neighbours)
            {
                columns.push_back(neighbour);
                values.push_back(neighbour == at(ix, iy) ? 4 * weight : -weight);
            }
            starts.push_back(static_cast<int>(columns.size()));
        }
    }
    return {lattice.points(), std::move(starts), std::move(columns), std::move(values)};
}

/// Choices of BoomerAMG, by hypre's numbers.
struct Choice
{
    bool fivePoint;   ///< built from the five-point Laplacian
    int coarsening;   ///< 8: PMIS, 10: HMIS
    double threshold; ///< of strong connections
    int smoother;     ///< 6: symmetric hybrid Gauss-Seidel, 16: Chebyshev, 18: l1-Jacobi
    int aggressive;   ///< levels of aggressive coarsening
};

std::string nameOf(const Choice& choice)
{
    return fmt::format("{}, {}, threshold {}, {}{}", choice.fivePoint ? "five points" : "the matrix",
                       choice.coarsening == 8 ? "PMIS" : "HMIS", choice.threshold,
                       choice.smoother == 6    ? "Gauss-Seidel"
                       : choice.smoother == 16 ? "Chebyshev"
                                               : "l1-Jacobi",
                       choice.aggressive > 0 ? ", aggressive" : "");
}

/// A multigrid with the matrix it is of, which need not be the one that is solved for.
struct MultigridOfMatrix
{
    HYPRE_Solver amg;
    HYPRE_ParCSRMatrix matrix;
};

HYPRE_Int applyMultigrid(HYPRE_Solver solver, HYPRE_Matrix, HYPRE_Vector b, HYPRE_Vector x)
{
    const auto* multigrid = reinterpret_cast<const MultigridOfMatrix*>(solver);
    return HYPRE_BoomerAMGSolve(multigrid->amg, multigrid->matrix, reinterpret_cast<HYPRE_ParVector>(b),
                                reinterpret_cast<HYPRE_ParVector>(x));
}

struct AmgCost
{
    double setup = 0;
    double solve = std::numeric_limits<double>::infinity();
    int iterations = 0;
    double residual = 0;
    double difference = 0;
};

AmgCost costOf(const Choice& choice, const PressureRace& race, const HypreMatrix& matrix, const HypreMatrix& near,
               const RealField& exact, int solves)
{
    AmgCost cost;
    RealField phi(1, race.lattice().points());
    RealField rhs = copyOf(race.source());
    for (double& value : rhs[0]) { value = -value; } // the matrix is minus the Laplacian
    HypreVector b(rhs[0]);
    HypreVector x(phi[0]);

    Owned<HYPRE_Solver, HYPRE_BoomerAMGDestroy> amg;
    HYPRE_BoomerAMGCreate(amg.out());
    HYPRE_BoomerAMGSetTol(amg.get(), 0);
    HYPRE_BoomerAMGSetMaxIter(amg.get(), 1);
    HYPRE_BoomerAMGSetCoarsenType(amg.get(), choice.coarsening);
    HYPRE_BoomerAMGSetInterpType(amg.get(), 6); // extended+i
    HYPRE_BoomerAMGSetPMaxElmts(amg.get(), 4);
    HYPRE_BoomerAMGSetStrongThreshold(amg.get(), choice.threshold);
    HYPRE_BoomerAMGSetAggNumLevels(amg.get(), choice.aggressive);
    HYPRE_BoomerAMGSetRelaxType(amg.get(), choice.smoother);
    HYPRE_BoomerAMGSetNumSweeps(amg.get(), 1);
    // The matrix is singular: the coarsest level is smoothed, not solved.
    HYPRE_BoomerAMGSetCycleRelaxType(amg.get(), 18, 3);
    HYPRE_BoomerAMGSetCycleNumSweeps(amg.get(), 8, 3);
    HYPRE_BoomerAMGSetPrintLevel(amg.get(), 0);

    Owned<HYPRE_Solver, HYPRE_ParCSRPCGDestroy> cg;
    HYPRE_ParCSRPCGCreate(MPI_COMM_WORLD, cg.out());
    HYPRE_PCGSetTol(cg.get(), 1e-10);
    HYPRE_PCGSetTwoNorm(cg.get(), 1);
    HYPRE_PCGSetMaxIter(cg.get(), 1000);
    MultigridOfMatrix preconditioner{amg.get(), choice.fivePoint ? near.get() : matrix.get()};
    HYPRE_PCGSetPrecond(
        cg.get(), applyMultigrid,
        // It is set up by hand.
        [](HYPRE_Solver, HYPRE_Matrix, HYPRE_Vector, HYPRE_Vector) -> HYPRE_Int { return 0; },
        reinterpret_cast<HYPRE_Solver>(&preconditioner));
    cost.setup = processorSecondsOf(
        [&]
        {
            HYPRE_BoomerAMGSetup(amg.get(), preconditioner.matrix, b.get(), x.get());
            HYPRE_ParCSRPCGSetup(cg.get(), matrix.get(), b.get(), x.get());
        });
    for (int i = 0; i < solves; ++i)
    {
        std::ranges::fill(phi[0], 0.0);
        x.set(phi[0]);
        cost.solve = std::min(
            cost.solve, processorSecondsOf([&] { HYPRE_ParCSRPCGSolve(cg.get(), matrix.get(), b.get(), x.get()); }));
    }
    HYPRE_PCGGetNumIterations(cg.get(), &cost.iterations);
    HYPRE_PCGGetFinalRelativeResidualNorm(cg.get(), &cost.residual);
    HYPRE_ClearAllErrors();
    x.read(phi[0]);
    cost.difference = largestDifference(phi, exact);
    return cost;
}

std::vector<Choice> allChoices()
{
    std::vector<Choice> choices;
    for (const bool fivePoint : {false, true})
    {
        for (const int coarsening : {8, 10})
        {
            for (const double threshold : {0.25, 0.5})
            {
                for (const int smoother : {6, 16, 18})
                {
                    choices.push_back({fivePoint, coarsening, threshold, smoother, 0});
                }
            }
        }
        choices.push_back({fivePoint, 8, 0.25, 6, 1});
    }
    return choices;
}

/// \return whether every choice found the pressure
bool race(int points, const std::string& kernel, int solves, bool print)
{
    const PressureRace race(points, kernel, 2);
    FourierPoisson byTransforms = race.byTransforms(PlanEffort::measured);
    RealField exact(1, race.lattice().points());
    double fft = std::numeric_limits<double>::infinity();
    for (int round = 0; round < 200; ++round)
    {
        fft = std::min(fft, processorSecondsOf([&] { byTransforms.solve(race.source(), exact); }));
    }
    const HypreMatrix matrix(race.system().matrix());
    const HypreMatrix near(fivePoints(race.lattice()));
    bool agree = true;
    std::vector<std::pair<Choice, AmgCost>> costs;
    for (const Choice& choice : allChoices())
    {
        const AmgCost cost = costOf(choice, race, matrix, near, exact, solves);
        const bool solved = cost.residual <= 1e-10 && cost.difference <= 1e-7;
        // Not every choice suits a matrix with entries of both signs; those that do must be right.
        if (cost.residual <= 1e-10 && !solved) { agree = false; }
        if (solved) { costs.emplace_back(choice, cost); }
    }
    if (costs.empty()) { return false; }
    std::ranges::sort(costs, {}, [](const auto& entry) { return entry.second.solve; });
    for (std::size_t i = 0; print && i < std::min<std::size_t>(4, costs.size()); ++i)
    {
        const auto& [choice, cost] = costs[i];
        fmt::print("| {}^2 | {} | {} | {:.3g} ms | {} | {:.3g} ms | {:.3g} ms | {:.0f} | {:.0f} |\n", points, kernel,
                   nameOf(choice), 1e3 * fft, cost.iterations, 1e3 * cost.solve, 1e3 * cost.setup, cost.solve / fft,
                   (cost.solve + cost.setup) / fft);
    }
    std::fflush(stdout);
    return agree;
}

} // namespace

int main(int argc, char** argv)
{
    MPI_Init(&argc, &argv);
    HYPRE_Init();
    bool agree = true;
    const std::string argument = argc > 1 ? argv[1] : "160";
    if (argument == "-test")
    {
        for (const char* kernel : racingKernels) { agree = race(32, kernel, 1, false) && agree; }
    }
    else
    {
        fmt::print(
            "{}",
            R"~(The pressure from a random source, with the Morris Laplacian of a kernel at h/dx = 2, from zero to a residual of 1e-10 by
conjugate gradients with hypre's BoomerAMG, one V-cycle, built from the matrix itself or from the five-point Laplacian: the
four fastest of 26 choices. Processor time of one thread.

| lattice | kernel | BoomerAMG of | transforms | iterations | solve | set-up | solve over transforms | with set-up |
| --- | --- | --- | --- | --- | --- | --- | --- | --- |
)~");
        for (const char* kernel : racingKernels) { agree = race(std::stoi(argument), kernel, 3, true) && agree; }
    }
    HYPRE_Finalize();
    MPI_Finalize();
    return agree ? EXIT_SUCCESS : EXIT_FAILURE;
}

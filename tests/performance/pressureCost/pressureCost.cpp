// pressureCost: what the pressure costs, by transforms and by the iterative solvers of classical ISPH, for the same
// Laplacian and the same random source.
//
//     OMP_NUM_THREADS=1 build/tests/pressureCost                              tables
//     OMP_NUM_THREADS=1 build/tests/pressureCost -kernel gaussian4 -sizes 20,40,80          CSV: N x N points, h/dx = 2
//     OMP_NUM_THREADS=1 build/tests/pressureCost -kernel gaussian4 -smoothing 1.3,2,4 -points 160   CSV: over h/dx
//
// Seconds are processor time of one thread, the least of several, taken in turn. Iterative solvers start from zero and
// end at a residual of 1e-10; solves that take longer than 10 s are made once, conjugate gradients up to 160 x 160
// points. Where the matrix does not fit into memory there are no iterative solvers.

#include "lattice/memoryEstimate.hpp"
#include "pressureRace.hpp"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <fmt/format.h>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

using namespace isph;
using namespace isph::test;

namespace
{

struct Options
{
    std::vector<double> sizes;
    std::vector<double> smoothing;
    int points = 160;
    std::string kernel = "quinticSpline";
    bool fftOnly = false;
};

struct Iterative
{
    double setup = 0;
    double solve = std::numeric_limits<double>::infinity();
    int iterations = 0;
    int solves = 0;
    double difference = 0; ///< of the solution from that by transforms
};

struct Costs
{
    double transforms = std::numeric_limits<double>::infinity(); ///< r2c + c2r alone
    double fft = std::numeric_limits<double>::infinity();
    double fftSetup = 0;
    std::size_t neighbours = 0;
    std::optional<Iterative> biCGStab; ///< none where the matrix does not fit into memory
    std::optional<Iterative> cg;
};

/// A solve by transforms and its transforms alone, in turn.
void raceTransforms(const PressureRace& race, Costs& costs, RealField& phi)
{
    std::optional<FourierPoisson> solver;
    costs.fftSetup = processorSecondsOf([&] { solver.emplace(race.byTransforms(PlanEffort::measured)); });
    FourierTransform pair(race.lattice(), 1, PlanEffort::measured);
    SpectralField modes(1, pair.modes());
    RealField real = copyOf(race.source());
    const int repetitions = std::max(1, 200000 / static_cast<int>(race.lattice().points()));
    for (int round = 0; round < 60; ++round)
    {
        const auto repeated = [&](auto work)
        {
            return processorSecondsOf(
                       [&]
                       {
                           for (int i = 0; i < repetitions; ++i) { work(); }
                       }) /
                   repetitions;
        };
        costs.transforms = std::min(costs.transforms, repeated(
                                                          [&]
                                                          {
                                                              pair.forward(race.source(), modes);
                                                              pair.backward(modes, real);
                                                          }));
        costs.fft = std::min(costs.fft, repeated([&] { solver->solve(race.source(), phi); }));
    }
}

Iterative raceIterative(const PressureRace& race, PressureSolver kind, const RealField& exact)
{
    Iterative cost;
    std::optional<IterativePoisson> solver;
    cost.setup = processorSecondsOf([&] { solver.emplace(race.iterative(kind)); });
    RealField phi(1, race.lattice().points());
    double spent = 0;
    for (; cost.solves < 3 && spent <= 10; ++cost.solves)
    {
        std::ranges::fill(phi[0], 0.0);
        const double seconds = processorSecondsOf([&] { solver->solve(race.source(), phi); });
        spent += seconds;
        cost.solve = std::min(cost.solve, seconds);
    }
    cost.iterations = solver->result().iterations;
    cost.difference = largestDifference(phi, exact);
    return cost;
}

Costs costsOf(int points, const std::string& kernel, double smoothing, const Options& options)
{
    const PressureRace race(points, kernel, smoothing);
    Costs costs;
    costs.neighbours = race.neighbours();
    RealField phi(1, race.lattice().points());
    raceTransforms(race, costs, phi);
    // Making the matrix needs it about twice.
    if (options.fftOnly || 2.2 * race.bytes() > machineMemory()) { return costs; }
    costs.biCGStab = raceIterative(race, PressureSolver::biCGStab, phi);
    if (points <= 160) { costs.cg = raceIterative(race, PressureSolver::cg, phi); }
    return costs;
}

void printCsv(const std::string& abscissa, const std::vector<double>& values, const Options& options)
{
    fmt::print("# {}; processor time of one thread; random source, residual 1e-10, Jacobi\n", options.kernel);
    fmt::print("{},neighbours,fft [s],r2c+c2r [s],fftSetup [s]", abscissa);
    for (const char* solver : {"BiCGStab", "CG"})
    {
        fmt::print(",{0} [s],{0}Setup [s],{0}Iterations,{0}Solves,{0}Difference", solver);
    }
    fmt::print("\n");
    for (const double value : values)
    {
        const bool sizes = abscissa == "N";
        const Costs costs =
            costsOf(sizes ? static_cast<int>(value) : options.points, options.kernel, sizes ? 2 : value, options);
        fmt::print("{},{},{:.4e},{:.4e},{:.3e}", value, costs.neighbours, costs.fft, costs.transforms, costs.fftSetup);
        for (const auto& solver : {costs.biCGStab, costs.cg})
        {
            if (solver)
            {
                fmt::print(",{:.4e},{:.3e},{},{},{:.1e}", solver->solve, solver->setup, solver->iterations,
                           solver->solves, solver->difference);
            }
            else { fmt::print(",,,,,"); }
        }
        fmt::print("\n");
        std::fflush(stdout);
    }
}

void printTables(const Options& options)
{
    fmt::print(
        "{}",
        R"~(The pressure at N x N points from a random source, both of mean zero, with the Morris Laplacian of a kernel: by
transforms, and by its matrix with BiCGStab and with conjugate gradients, both preconditioned by Jacobi, from zero to a
residual of 1e-10. Seconds are processor time of one thread, the least of several, taken in turn.

| N | kernel, h/dx | neighbours | transforms | over r2c + c2r | BiCGStab: solve; iterations | ratio | CG: solve; iterations | ratio | matrix |
| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |
)~");
    const auto row = [](int points, const char* kernel, double smoothing, const Costs& costs)
    {
        fmt::print("| {} | {}, {} | {} | {:.3g} ms | {:.2f} |", points, kernel, smoothing, costs.neighbours,
                   1e3 * costs.fft, costs.fft / costs.transforms);
        for (const auto& solver : {costs.biCGStab, costs.cg})
        {
            if (solver)
            {
                fmt::print(" {:.3g} s; {} | {:.0f} |", solver->solve, solver->iterations, solver->solve / costs.fft);
            }
            else { fmt::print(" - | - |"); }
        }
        if (costs.cg) { fmt::print(" {:.2g} s |\n", costs.cg->setup); }
        else { fmt::print(" - |\n"); }
        std::fflush(stdout);
    };
    for (const char* kernel : racingKernels)
    {
        for (const int points : {40, 80, 160}) { row(points, kernel, 2, costsOf(points, kernel, 2, options)); }
    }
    fmt::print(
        "\nOver the smoothing length, 160 x 160 points, by transforms:\n\n| kernel | h/dx | neighbours | solve | "
        "over r2c + c2r |\n| --- | --- | --- | --- | --- |\n");
    Options fftOnly = options;
    fftOnly.fftOnly = true;
    for (const char* kernel : racingKernels)
    {
        for (const double smoothing : {1.3, 2.0, 3.0, 4.0})
        {
            const Costs costs = costsOf(160, kernel, smoothing, fftOnly);
            fmt::print("| {} | {} | {} | {:.3g} ms | {:.2f} |\n", kernel, smoothing, costs.neighbours, 1e3 * costs.fft,
                       costs.fft / costs.transforms);
            std::fflush(stdout);
        }
    }
}

/// Points or smoothing lengths that a race can be run with.
std::vector<double> numbers(const std::string& list)
{
    std::vector<double> values;
    std::istringstream stream(list);
    for (std::string text; std::getline(stream, text, ',');)
    {
        double value = 0;
        const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
        if (read.ec != std::errc() || read.ptr != text.data() + text.size() || !(value > 0 && value < 1e5))
        {
            throw std::invalid_argument("'" + text + "' is no number that can be");
        }
        values.push_back(value);
    }
    if (values.empty()) { throw std::invalid_argument("a list of numbers is missing"); }
    return values;
}

Options optionsOf(const std::vector<std::string>& words)
{
    Options options;
    for (std::size_t i = 0; i < words.size(); i += 2)
    {
        const std::string value = i + 1 < words.size() ? words[i + 1] : "";
        if (words[i] == "-sizes") { options.sizes = numbers(value); }
        else if (words[i] == "-smoothing") { options.smoothing = numbers(value); }
        else if (words[i] == "-points") { options.points = static_cast<int>(numbers(value).front()); }
        else if (words[i] != "-kernel") { throw std::invalid_argument("unknown option " + words[i]); }
        else if (std::ranges::find(racingKernels, value) != racingKernels.end()) { options.kernel = value; }
        else { throw std::invalid_argument("there is no kernel '" + value + "' in the race"); }
    }
    return options;
}

} // namespace

int main(int argc, char** argv)
{
    Options options;
    try
    {
        options = optionsOf({argv + 1, argv + argc});
    }
    catch (const std::invalid_argument& error)
    {
        fmt::print(stderr, "pressureCost: {}\n    -kernel {} -sizes N,... | -smoothing H,... [-points N], or nothing\n",
                   error.what(), fmt::join(racingKernels, "|"));
        return 2;
    }
    if (!options.sizes.empty()) { printCsv("N", options.sizes, options); }
    if (!options.smoothing.empty()) { printCsv("h/dx", options.smoothing, options); }
    if (options.sizes.empty() && options.smoothing.empty()) { printTables(options); }
}

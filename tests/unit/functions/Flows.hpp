#pragma once

#include "core/Timings.hpp"
#include "fields/threads.hpp"
#include "flow/SpectralFlow.hpp"
#include "functions/FunctionObject.hpp"
#include "kernels/ExactKernel.hpp"
#include "lattice/Lattice.hpp"

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <numbers>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace isph::test
{

inline constexpr double pi = std::numbers::pi;

/// One thread, as the programs have unless they are told otherwise: waiting threads would hold up a busy machine.
inline const int threads = useRequestedThreads();

/// A periodic square of side 1 in x and y.
inline Lattice square(int n) { return Lattice({Axis{'x', 0, 1, n}, Axis{'y', 0, 1, n}, Axis{'z'}}, {}); }

/// The same in x and z.
inline Lattice upright(int n) { return Lattice({Axis{'x', 0, 1, n}, Axis{'y'}, Axis{'z', 0, 1, n}}, {}); }

/// Sets a component to f(x, y, z).
template<class Function>
void fill(RealField& field, int component, const Lattice& lattice, Function f)
{
    const auto [x, y, z] = lattice.coordinates();
    for (std::size_t n = 0; n < field.size(); ++n) { field[component][n] = f(x[n], y[n], z[n]); }
}

/// A flow that is what a test says.
class GivenFlow : public IncompressibleFlow
{
public:
    explicit GivenFlow(const Lattice& lattice)
        : U(lattice.dimensions(), lattice.points()), p(1, lattice.points()), div(1, lattice.points())
    {
    }

    StartReport start(const RealField&, bool) override { return {}; }
    void save(FieldWriter&) const override {}
    void restore(const FieldReader&) override {}
    bool restores(const FieldReader&) const override { return false; }
    void stepBack() override {}
    void advance(const Substep&, double, double) override {}
    StepRates rates() override { return {.courant = 8, .meanCourant = 2}; }
    const RealField& velocity() override { return U; }
    const RealField& pressure(double) override { return p; }
    const RealField& divergence() override { return div; }
    long transforms() const override { return 0; }
    std::string planFingerprint() const override { return ""; }

    RealField U;
    RealField p;
    RealField div;
};

/// Vortices of Taylor and Green that decay in a unit square, marched with exact derivatives.
class TaylorGreen
{
public:
    TaylorGreen(int n, double nu) : lattice(square(n))
    {
        fluid.nu = nu;
        settings.kernel.kernel = std::make_unique<ExactKernel>();
        settings.laplacian = LaplacianForm::exact;
        settings.time = timeSchemes()[Word{"RK3", {}}];
        flow = std::make_unique<SpectralFlow>(lattice, fluid, settings, timings, PlanEffort::estimated);
        RealField U(2, lattice.points());
        fill(U, 0, lattice, [](double x, double y, double) { return -std::cos(2 * pi * x) * std::sin(2 * pi * y); });
        fill(U, 1, lattice, [](double x, double y, double) { return std::sin(2 * pi * x) * std::cos(2 * pi * y); });
        flow->start(U, true);
    }

    void step(double dt)
    {
        advance(*settings.time, *flow, time, dt);
        time += dt;
        ++steps;
        lastStep = dt;
    }

    FlowAtTime now(const std::string& name = "") const
    {
        return {.flow = *flow,
                .time = time,
                .name = name,
                .step = steps,
                .cpuTime = 1,
                .wallTime = 2,
                .timings = timings,
                .dt = lastStep};
    }

    Lattice lattice;
    Fluid fluid;
    FlowSettings settings;
    Timings timings;
    std::unique_ptr<SpectralFlow> flow;
    double time = 0;
    long steps = 0;
    double lastStep = 0;
};

/// A time of a given flow.
inline FlowAtTime at(IncompressibleFlow& flow, const Timings& timings, double time, const std::string& name = "")
{
    return {.flow = flow,
            .time = time,
            .name = name,
            .step = 3,
            .cpuTime = 1,
            .wallTime = 2,
            .timings = timings,
            .dt = 0.5};
}

/// A folder that goes with the test.
class TemporaryFolder
{
public:
    TemporaryFolder()
    {
        std::string pattern = (std::filesystem::temp_directory_path() / "functionsXXXXXX").string();
        path = mkdtemp(pattern.data());
    }
    ~TemporaryFolder() { std::filesystem::remove_all(path); }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    std::filesystem::path path;
};

/// The lines of a file.
inline std::vector<std::string> linesOf(const std::filesystem::path& file)
{
    std::ifstream in(file);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) { lines.push_back(line); }
    return lines;
}

/// Columns of a CSV file by their heads.
inline std::map<std::string, std::vector<double>> readCsv(const std::filesystem::path& file)
{
    const std::vector<std::string> lines = linesOf(file);
    std::map<std::string, std::vector<double>> columns;
    if (lines.empty()) { return columns; }
    for (std::size_t row = 1; row < lines.size(); ++row)
    {
        std::istringstream heads(lines[0]);
        std::istringstream values(lines[row]);
        for (std::string head, value; std::getline(heads, head, ',') && std::getline(values, value, ',');)
        {
            columns[head].push_back(std::stod(value));
        }
    }
    return columns;
}

} // namespace isph::test

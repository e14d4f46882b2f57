#include "PlainStep.hpp"

#include "flow/convectiveRates.hpp"
#include "flow/sceneSymbols.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace isph::test
{

namespace
{

double* pairs(SpectralField& field, int component) { return reinterpret_cast<double*>(field[component].data()); }

template<int D, bool Viscous>
class PlainPeriodic : public PlainStep
{
public:
    PlainPeriodic(const Scene& scene, const RealField& start, PlanEffort effort)
        : lattice_(scene.lattice),
          bounds_(boundsOf(scene.lattice, scene.fluid, scene.settings)),
          nu_(scene.fluid.nu),
          rows_(scene.lattice),
          inputTransform_(scene.lattice, D, effort),
          productTransform_(scene.lattice, products, effort),
          state_(D, rows_.modes()),
          before_(D, rows_.modes()),
          rate_(D, rows_.modes()),
          inputs_(D, rows_.modes()),
          productModes_(products, rows_.modes()),
          points_(products, scene.lattice.points()),
          q_(rows_.modes(), 1),
          inverse_(rows_.modes())
    {
        const DerivativeSymbol derivative = derivativeOf(scene.lattice, scene.settings.kernel);
        std::array<std::vector<double>, 3> d;
        for (auto& values : d) { values.resize(rows_.length()); }
        const auto& k0 = rows_.wavenumbers().derivative[0];
        for (std::size_t row = 0; row < rows_.count(); ++row)
        {
            derivative.row(row, 0, rows_.length(), {d[0].data(), d[1].data(), d[2].data()});
            for (std::size_t i = 0; i < rows_.length(); ++i)
            {
                const std::size_t mode = rows_.offset(row) + i;
                double k2 = k0[i] * k0[i];
                double dk = d[0][i] * k0[i];
                for (int axis = 1; axis < D; ++axis)
                {
                    const double k = rows_.derivative(row, axis);
                    k2 += k * k;
                    dk += d[static_cast<std::size_t>(axis)][i] * k;
                }
                q_[mode] = k2 > 0 ? dk / k2 : 1;
                inverse_[mode] = k2 > 0 ? 1 / k2 : 0;
                if (rows_.checkerboard(row, i)) { checkerboards_.push_back(mode); }
            }
        }
        if constexpr (Viscous)
        {
            symbol_ = laplacianOf(scene.lattice, scene.settings.kernel, scene.settings.laplacian);
            for (double& value : symbol_) { value *= scene.fluid.nu; }
        }
        for (const Substep& substep : scene.settings.time->substeps)
        {
            substeps_.push_back(substep);
            const auto known = std::ranges::find(lengths_, substep.a);
            tableOf_.push_back(static_cast<std::size_t>(known - lengths_.begin()));
            if (known == lengths_.end()) { lengths_.push_back(substep.a); }
        }
        for (std::size_t t = 0; Viscous && t < lengths_.size(); ++t) { lessOne_.emplace_back(rows_.modes()); }

        RealField copy = copyOf(start);
        inputTransform_.forward(copy, inputs_);
        for (int c = 0; c < D; ++c)
        {
            for (auto& value : inputs_[c]) { value /= static_cast<double>(start.size()); }
            std::ranges::copy(inputs_[c], state_[c].begin());
        }
        clear();
        inputTransform_.backward(inputs_, points_);
    }

    void step(double dt) override
    {
        if (Viscous && dt != dt_)
        {
            for (std::size_t t = 0; t < lengths_.size(); ++t)
            {
                for (std::size_t i = 0; i < symbol_.size(); ++i)
                {
                    lessOne_[t][i] = std::expm1(-lengths_[t] * dt * symbol_[i]);
                }
            }
            dt_ = dt;
        }
        std::swap(state_, before_);
        substep<true, false>(0, dt, before_);
        substep<false, false>(1, dt, state_);
        substep<false, true>(2, dt, state_);
        rates_ = {};
        addConvectiveRates(lattice_, points_, bounds_, nu_, rates_);
    }

    RealField velocity() override
    {
        RealField result(D, points_.size());
        for (int c = 0; c < D; ++c) { std::ranges::copy(points_[c], result[c].begin()); }
        return result;
    }

private:
    static constexpr int products = D == 2 ? 2 : 5;

    void multiply()
    {
        std::array<double*, products> p;
        for (int c = 0; c < products; ++c) { p[static_cast<std::size_t>(c)] = points_[c].data(); }
        const std::size_t size = points_.size();
#pragma GCC ivdep
        for (std::size_t i = 0; i < size; ++i)
        {
            const double x = p[0][i];
            const double y = p[1][i];
            if constexpr (D == 2)
            {
                p[0][i] = (x - y) * (x + y);
                p[1][i] = x * y;
            }
            else
            {
                const double z = p[2][i];
                p[0][i] = (x - z) * (x + z);
                p[1][i] = (y - z) * (y + z);
                p[2][i] = x * y;
                p[3][i] = x * z;
                p[4][i] = y * z;
            }
        }
    }

    template<bool First, bool Last>
    void substep(std::size_t index, double dt, SpectralField& from)
    {
        multiply();
        productTransform_.forward(points_, productModes_);
        const double now = dt * substeps_[index].g;
        const double past = dt * substeps_[index].z;
        const double scale = 1.0 / static_cast<double>(points_.size());
        const double* k0 = rows_.wavenumbers().derivative[0].data();
        for (std::size_t row = 0; row < rows_.count(); ++row)
        {
            const double ky = rows_.derivative(row, 1);
            const double kz = D == 3 ? rows_.derivative(row, 2) : 0;
            const std::size_t offset = rows_.offset(row);
            const auto at = [offset](SpectralField& field, int c) { return pairs(field, c) + 2 * offset; };
            std::array<const double*, products> p;
            for (int c = 0; c < products; ++c) { p[static_cast<std::size_t>(c)] = at(productModes_, c); }
            std::array<const double*, D> old;
            std::array<double*, D> value;
            std::array<double*, D> input;
            std::array<double*, D> carried;
            for (int c = 0; c < D; ++c)
            {
                const auto component = static_cast<std::size_t>(c);
                old[component] = at(from, c);
                value[component] = at(state_, c);
                input[component] = at(inputs_, c);
                carried[component] = at(rate_, c);
            }
            const double* q = q_.data() + offset;
            const double* inverse = inverse_.data() + offset;
            const double* lessOne = Viscous ? lessOne_[tableOf_[index]].data() + offset : nullptr;
            const std::size_t length = rows_.length();
#pragma GCC ivdep
            for (std::size_t i = 0; i < length; ++i)
            {
                const double x = -scale * q[i] * k0[i];
                const double y = -scale * q[i] * ky;
                const double z = -scale * q[i] * kz;
                const auto rateOf = [&](double re, double im) { return std::array<double, 2>{-im, re}; };
                std::array<std::array<double, 2>, D> F;
                const std::size_t n = 2 * i;
                if constexpr (D == 2)
                {
                    F[0] = rateOf(x * p[0][n] + y * p[1][n], x * p[0][n + 1] + y * p[1][n + 1]);
                    F[1] = rateOf(x * p[1][n], x * p[1][n + 1]);
                }
                else
                {
                    F[0] = rateOf(x * p[0][n] + y * p[2][n] + z * p[3][n],
                                  x * p[0][n + 1] + y * p[2][n + 1] + z * p[3][n + 1]);
                    F[1] = rateOf(x * p[2][n] + y * p[1][n] + z * p[4][n],
                                  x * p[2][n + 1] + y * p[1][n + 1] + z * p[4][n + 1]);
                    F[2] = rateOf(x * p[3][n] + y * p[4][n], x * p[3][n + 1] + y * p[4][n + 1]);
                }
                for (std::size_t part = 0; part < 2; ++part)
                {
                    std::array<double, D> u;
                    for (std::size_t c = 0; c < D; ++c)
                    {
                        u[c] = old[c][n + part] + now * F[c][part];
                        if constexpr (!First) { u[c] += past * carried[c][n + part]; }
                        double keep = F[c][part];
                        if constexpr (Viscous)
                        {
                            u[c] += lessOne[i] * u[c];
                            keep += lessOne[i] * keep;
                        }
                        if constexpr (!Last) { carried[c][n + part] = keep; }
                    }
                    double sum = k0[i] * u[0] + ky * u[1];
                    if constexpr (D == 3) { sum += kz * u[2]; }
                    sum *= inverse[i];
                    u[0] -= k0[i] * sum;
                    u[1] -= ky * sum;
                    if constexpr (D == 3) { u[2] -= kz * sum; }
                    for (std::size_t c = 0; c < D; ++c) { value[c][n + part] = input[c][n + part] = u[c]; }
                }
            }
        }
        clear();
        inputTransform_.backward(inputs_, points_);
    }

    /// Checkerboards, which products alias onto.
    void clear()
    {
        for (const std::size_t mode : checkerboards_)
        {
            for (int c = 0; c < D; ++c) { state_[c][mode] = inputs_[c][mode] = 0; }
        }
    }

    Lattice lattice_;
    OperatorBounds bounds_;
    double nu_;
    ModeRows rows_;
    FourierTransform inputTransform_;
    FourierTransform productTransform_;
    SpectralField state_;
    SpectralField before_; // what a diverged run is taken back to
    SpectralField rate_;
    SpectralField inputs_;
    SpectralField productModes_;
    RealField points_;
    AlignedVector<double> q_; // of the kernel
    AlignedVector<double> inverse_;
    AlignedVector<double> symbol_; // nu times minus the Laplacian
    std::vector<std::size_t> checkerboards_;
    std::vector<Substep> substeps_;
    std::vector<double> lengths_;
    std::vector<std::size_t> tableOf_;
    std::vector<AlignedVector<double>> lessOne_;
    double dt_ = 0;
    StepRates rates_;
};

} // namespace

std::unique_ptr<PlainStep> plainPeriodic(const Scene& scene, const RealField& start, PlanEffort effort)
{
    const bool viscous = scene.fluid.nu > 0;
    if (scene.lattice.dimensions() == 3) { return std::make_unique<PlainPeriodic<3, true>>(scene, start, effort); }
    if (viscous) { return std::make_unique<PlainPeriodic<2, true>>(scene, start, effort); }
    return std::make_unique<PlainPeriodic<2, false>>(scene, start, effort);
}

} // namespace isph::test

#include "spectral/LineTransform.hpp"

#include "core/Error.hpp"
#include "spectral/FftwPlan.hpp"
#include "spectral/wisdom.hpp"

#include <cassert>

namespace isph
{

struct LineTransform::Plans
{
    int length;
    int lines;
    FftwPlan forward;
    FftwPlan backward;
};

LineTransform::LineTransform(int length, int lines, PlanEffort effort)
    : plans_(std::make_unique<Plans>(Plans{length, lines, nullptr, nullptr}))
{
    RealField real = realLines();
    SpectralField modes = modesOfLines();
    const auto plan = [&](unsigned rigor)
    {
        auto* complexes = reinterpret_cast<fftw_complex*>(modes.data());
        const auto realStride = static_cast<int>(real.stride());
        const auto modeStride = static_cast<int>(modes.stride());
        plans_->forward.reset(fftw_plan_many_dft_r2c(1, &length, lines, real.data(), nullptr, 1, realStride, complexes,
                                                     nullptr, 1, modeStride, rigor | FFTW_PRESERVE_INPUT));
        plans_->backward.reset(fftw_plan_many_dft_c2r(1, &length, lines, complexes, nullptr, 1, modeStride, real.data(),
                                                      nullptr, 1, realStride, rigor | FFTW_DESTROY_INPUT));
    };
    withPlanner(1,
                [&]
                {
                    const bool kept = effort == PlanEffort::measured && withWisdom([&plan] { plan(FFTW_MEASURE); });
                    if (!kept) { plan(FFTW_ESTIMATE); }
                });
    if (!plans_->forward || !plans_->backward) { throw Error(Fault::input, "FFTW found no plan for these lines"); }
}

LineTransform::~LineTransform() = default;
LineTransform::LineTransform(LineTransform&&) noexcept = default;
LineTransform& LineTransform::operator=(LineTransform&&) noexcept = default;

void LineTransform::forward(const RealField& real, SpectralField& modes) const
{
    assert(real.components() == plans_->lines && real.size() == static_cast<std::size_t>(plans_->length));
    assert(modes.components() == plans_->lines && modes.size() == static_cast<std::size_t>(plans_->length / 2 + 1));
    // FFTW takes no const input, but PRESERVE_INPUT keeps the promise.
    fftw_execute_dft_r2c(plans_->forward.get(), const_cast<double*>(real.data()),
                         reinterpret_cast<fftw_complex*>(modes.data()));
}

void LineTransform::backward(SpectralField& modes, RealField& real) const
{
    assert(real.components() == plans_->lines && real.size() == static_cast<std::size_t>(plans_->length));
    assert(modes.components() == plans_->lines && modes.size() == static_cast<std::size_t>(plans_->length / 2 + 1));
    fftw_execute_dft_c2r(plans_->backward.get(), reinterpret_cast<fftw_complex*>(modes.data()), real.data());
}

int LineTransform::length() const { return plans_->length; }
int LineTransform::lines() const { return plans_->lines; }

RealField LineTransform::realLines() const
{
    return RealField(plans_->lines, static_cast<std::size_t>(plans_->length));
}

SpectralField LineTransform::modesOfLines() const
{
    return SpectralField(plans_->lines, static_cast<std::size_t>(plans_->length / 2 + 1));
}

} // namespace isph

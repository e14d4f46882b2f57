#include "spectral/FourierTransform.hpp"

#include "core/Error.hpp"
#include "spectral/FftwPlan.hpp"
#include "spectral/wisdom.hpp"

#include <cassert>
#include <cstdint>
#include <cstdlib>
#include <omp.h>
#include <vector>

namespace isph
{

namespace
{

std::string textOf(fftw_plan plan)
{
    char* text = fftw_sprint_plan(plan);
    std::string copy(text);
    std::free(text);
    return copy;
}

/// FNV-1a: a fingerprint must not change with the library that hashes it.
std::string hashOf(const std::string& text)
{
    std::uint64_t hash = 0xcbf29ce484222325U;
    for (const char c : text)
    {
        hash ^= static_cast<unsigned char>(c);
        hash *= 0x100000001b3U;
    }
    constexpr const char* digits = "0123456789abcdef";
    std::string result;
    for (int shift = 60; shift >= 0; shift -= 4) { result += digits[(hash >> shift) & 0xfU]; }
    return result;
}

} // namespace

std::array<std::size_t, 3> modeExtents(const Lattice& lattice)
{
    std::array<std::size_t, 3> extents{1, 1, 1};
    for (int d = 0; d < lattice.dimensions(); ++d)
    {
        const auto n = static_cast<std::size_t>(lattice.activeAxis(d).count);
        extents[static_cast<std::size_t>(d)] = d == 0 ? n / 2 + 1 : n;
    }
    return extents;
}

struct FourierTransform::Plans
{
    int components;
    std::size_t points;
    std::size_t modes;
    FftwPlan forward;
    FftwPlan backward;
    std::string fingerprint;
    long count = 0;
};

FourierTransform::FourierTransform(const Lattice& lattice, int components, PlanEffort effort)
    : plans_(std::make_unique<Plans>())
{
    const auto extents = modeExtents(lattice);
    plans_->components = components;
    plans_->points = lattice.points();
    plans_->modes = extents[0] * extents[1] * extents[2];

    std::vector<int> counts; // slowest axis first, as FFTW wants them
    for (int d = lattice.dimensions() - 1; d >= 0; --d) { counts.push_back(lattice.activeAxis(d).count); }

    RealField real(components, plans_->points);
    SpectralField modes(components, plans_->modes);
    const auto plan = [&](unsigned rigor)
    {
        auto* complexes = reinterpret_cast<fftw_complex*>(modes.data());
        const auto rank = static_cast<int>(counts.size());
        const auto realStride = static_cast<int>(real.stride());
        const auto modeStride = static_cast<int>(modes.stride());
        plans_->forward.reset(fftw_plan_many_dft_r2c(rank, counts.data(), components, real.data(), nullptr, 1,
                                                     realStride, complexes, nullptr, 1, modeStride,
                                                     rigor | FFTW_PRESERVE_INPUT));
        plans_->backward.reset(fftw_plan_many_dft_c2r(rank, counts.data(), components, complexes, nullptr, 1,
                                                      modeStride, real.data(), nullptr, 1, realStride,
                                                      rigor | FFTW_DESTROY_INPUT));
    };

    withPlanner(omp_get_max_threads(),
                [&]
                {
                    if (effort == PlanEffort::measured)
                    {
                        const bool kept = withWisdom([&plan] { plan(FFTW_MEASURE); });
                        // Without a place for wisdom the next run could measure its way to another plan, and so to
                        // other bits.
                        if (!kept) { plan(FFTW_ESTIMATE); }
                    }
                    else { plan(FFTW_ESTIMATE); }
                });
    if (!plans_->forward || !plans_->backward) { throw Error(Fault::input, "FFTW found no plan for this lattice"); }
    plans_->fingerprint = hashOf(textOf(plans_->forward.get()) + textOf(plans_->backward.get()));
}

FourierTransform::~FourierTransform() = default;
FourierTransform::FourierTransform(FourierTransform&&) noexcept = default;
FourierTransform& FourierTransform::operator=(FourierTransform&&) noexcept = default;

void FourierTransform::forward(const RealField& real, SpectralField& modes)
{
    assert(real.components() >= plans_->components && real.size() == plans_->points);
    assert(modes.components() >= plans_->components && modes.size() == plans_->modes);
    // FFTW takes no const input, but PRESERVE_INPUT keeps the promise.
    fftw_execute_dft_r2c(plans_->forward.get(), const_cast<double*>(real.data()),
                         reinterpret_cast<fftw_complex*>(modes.data()));
    plans_->count += plans_->components;
}

void FourierTransform::backward(SpectralField& modes, RealField& real)
{
    assert(real.components() >= plans_->components && real.size() == plans_->points);
    assert(modes.components() >= plans_->components && modes.size() == plans_->modes);
    fftw_execute_dft_c2r(plans_->backward.get(), reinterpret_cast<fftw_complex*>(modes.data()), real.data());
    plans_->count += plans_->components;
}

int FourierTransform::components() const { return plans_->components; }
std::size_t FourierTransform::points() const { return plans_->points; }
std::size_t FourierTransform::modes() const { return plans_->modes; }
long FourierTransform::count() const { return plans_->count; }
const std::string& FourierTransform::fingerprint() const { return plans_->fingerprint; }

} // namespace isph

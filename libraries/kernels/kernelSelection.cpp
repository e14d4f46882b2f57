#include "kernels/kernelSelection.hpp"

#include "kernels/ExactKernel.hpp"
#include "kernels/Gaussian.hpp"
#include "kernels/QuinticSpline.hpp"

#include <array>

namespace isph
{

namespace
{

using Maker = std::unique_ptr<Kernel> (*)(const Dictionary&);

std::unique_ptr<Kernel> makeGaussian(const Dictionary& dictionary)
{
    try
    {
        return std::make_unique<Gaussian>(dictionary.integer("order"));
    }
    catch (const Error& slip)
    {
        if (!slip.complaints().front().origin.file.empty()) { throw; }
        throw dictionary.error("order", slip.complaints().front().what, slip.complaints().front().advice);
    }
}

std::unique_ptr<Kernel> makeQuinticSpline(const Dictionary&) { return std::make_unique<QuinticSpline>(); }

std::unique_ptr<Kernel> makeExact(const Dictionary&) { return std::make_unique<ExactKernel>(); }

constexpr std::array<Selection<Maker>::Variant, 3> table{{
    {"gaussian", "any even order: 2, 4, ...; infinitely smooth", &makeGaussian},
    {"quinticSpline", "second order, support 3h; always sampled", &makeQuinticSpline},
    {"exact", "the exact derivative, the limit of infinite order", &makeExact},
}};
static_assert(distinct(table));

} // namespace

const Selection<Maker>& kernels()
{
    static constexpr Selection<Maker> selection("kernel", table);
    return selection;
}

Key kernelKey(const std::string& defaultOrder)
{
    using Type = Key::Type;
    Key key{.name = "kernel", .type = Type::dictionary, .meaning = "the smoothing kernel", .required = true};
    key.keys = {
        {.name = "type",
         .type = Type::word,
         .meaning = "gaussian | quinticSpline | exact",
         .required = true,
         .words = kernels().names()},
        {.name = "order", .type = Type::integer, .fallback = defaultOrder, .meaning = "gaussian: any even order"},
        {.name = "smoothingLength",
         .type = Type::number,
         .unit = "h/dx",
         .fallback = "auto",
         .meaning = "auto: closed 1.5, sampled 2",
         .words = {"auto"},
         .maximum = 100,
         .positive = true},
        {.name = "symbol",
         .type = Type::word,
         .fallback = "closed",
         .meaning = "closed: analytic Fourier symbol; sampled: transform of the truncated lattice kernel",
         .words = {"closed", "sampled"}},
        {.name = "supportRadius",
         .type = Type::number,
         .unit = "h",
         .fallback = "auto",
         .meaning = "sampled: 3 quinticSpline; gaussian 5 up to order 4, 6 up to 10, 7 above",
         .words = {"auto"},
         .maximum = 100,
         .positive = true},
        {.name = "renormalise",
         .type = Type::flag,
         .fallback = "no",
         .meaning = "sampled: divide by the discrete second moment"},
    };
    return key;
}

KernelSettings selectKernel(const Dictionary& dictionary)
{
    KernelSettings settings;
    settings.kernel = kernels()[dictionary.word("type")](dictionary);
    const bool sampled = dictionary.word("symbol").text == "sampled" || !settings.kernel->closed();
    settings.symbol = sampled && !settings.exact() ? KernelSettings::Symbol::sampled : KernelSettings::Symbol::closed;

    const auto isAuto = [&dictionary](std::string_view key)
    { return dictionary.find(key)->tokens().front().kind != Token::Kind::number; };
    settings.smoothingLength = isAuto("smoothingLength") ? (sampled ? 2.0 : 1.5) : dictionary.number("smoothingLength");
    settings.supportRadius =
        isAuto("supportRadius") ? settings.kernel->supportRadius() : dictionary.number("supportRadius");
    settings.renormalise = dictionary.flag("renormalise");
    return settings;
}

} // namespace isph

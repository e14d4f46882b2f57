#include "core/Error.hpp"

#include <utility>

namespace isph
{

std::string toString(const Origin& origin)
{
    std::string text = origin.file;
    if (origin.line > 0) { text += ":" + std::to_string(origin.line); }
    if (!origin.entry.empty()) { text += (text.empty() ? "" : ": ") + origin.entry; }
    return text;
}

Error::Error(Fault fault, Origin origin, std::string what, std::string advice)
    : Error(fault, {Complaint{std::move(origin), std::move(what), std::move(advice)}})
{
}

Error::Error(Fault fault, std::string what, std::string advice)
    : Error(fault, Origin{}, std::move(what), std::move(advice))
{
}

Error::Error(Fault fault, std::vector<Complaint> complaints) : fault_(fault), complaints_(std::move(complaints))
{
    for (const Complaint& complaint : complaints_)
    {
        if (!text_.empty()) { text_ += '\n'; }
        const std::string where = toString(complaint.origin);
        text_ += where + (where.empty() ? "" : ": ") + complaint.what;
        if (!complaint.advice.empty()) { text_ += "\n    " + complaint.advice; }
    }
}

} // namespace isph

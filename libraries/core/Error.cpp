#include "core/Error.hpp"

#include <utility>

namespace isph
{

std::string toString(const Origin& origin)
{
    std::string text = origin.file;
    if (origin.line > 0) { text.append(":").append(std::to_string(origin.line)); }
    if (!origin.entry.empty()) { text.append(text.empty() ? "" : ": ").append(origin.entry); }
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
        text_.append(where).append(where.empty() ? "" : ": ").append(complaint.what);
        if (!complaint.advice.empty()) { text_.append("\n    ").append(complaint.advice); }
    }
}

} // namespace isph

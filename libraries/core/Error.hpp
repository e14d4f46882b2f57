#pragma once

#include "core/Origin.hpp"

#include <exception>
#include <string>
#include <vector>

namespace isph
{

/// Whose fault an error is; the value is the exit code of the program.
enum class Fault
{
    input = 1,    ///< bad input, or the machine refused (disk full, no permission)
    usage = 2,    ///< wrong command line
    diverged = 3, ///< the solution left the finite numbers
};

/// One fact that is wrong: where, what, and what to do about it.
struct Complaint
{
    Origin origin;
    std::string what;   ///< "is -2 but must be positive"
    std::string advice; ///< "write h/dx, e.g. smoothingLength 2;"; may be empty

    bool operator==(const Complaint&) const = default;
};

/// The one exception of the suite, thrown anywhere and printed once, by runApplication.
class Error : public std::exception
{
public:
    Error(Fault fault, Origin origin, std::string what, std::string advice = "");
    Error(Fault fault, std::string what, std::string advice = "");

    /// Several slips found in one go. complaints must not be empty.
    Error(Fault fault, std::vector<Complaint> complaints);

    Fault fault() const { return fault_; }
    const std::vector<Complaint>& complaints() const { return complaints_; }

    /// All complaints, one or two lines each: "file:line: entry: what" and the advice indented.
    const char* what() const noexcept override { return text_.c_str(); }

private:
    Fault fault_;
    std::vector<Complaint> complaints_;
    std::string text_;
};

} // namespace isph

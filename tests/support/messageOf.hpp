#pragma once

#include "core/Error.hpp"

#include <string>

namespace isph
{

/// The text of the Error that a call throws, or that it threw none.
template<class Call>
std::string messageOf(const Call& call)
{
    try
    {
        call();
    }
    catch (const Error& error)
    {
        return error.what();
    }
    return "no error";
}

} // namespace isph

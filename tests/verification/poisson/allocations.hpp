#pragma once

namespace isph::test
{

/// Memory this program has asked operator new for so far, in calls.
long allocations();

} // namespace isph::test

#include "fieldStore/Hdf5Handle.hpp"

namespace isph
{

std::string hdf5Reason()
{
    std::string reason = "HDF5 gives no reason";
    const auto keepInnermost = [](unsigned, const H5E_error2_t* error, void* text) -> herr_t
    {
        if (error->desc != nullptr) { *static_cast<std::string*>(text) = error->desc; }
        return 0;
    };
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_DOWNWARD, keepInnermost, &reason);
    return reason;
}

} // namespace isph

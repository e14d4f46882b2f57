# Finds double-precision FFTW and its OpenMP part: targets FFTW3::fftw3 and FFTW3::omp.
find_path(FFTW3_INCLUDE_DIR fftw3.h)
find_library(FFTW3_LIBRARY fftw3)
find_library(FFTW3_OMP_LIBRARY fftw3_omp)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(FFTW3 REQUIRED_VARS FFTW3_LIBRARY FFTW3_OMP_LIBRARY FFTW3_INCLUDE_DIR
    REASON_FAILURE_MESSAGE "install libfftw3-dev (Debian)")
if(FFTW3_FOUND AND NOT TARGET FFTW3::fftw3)
    add_library(FFTW3::fftw3 UNKNOWN IMPORTED)
    set_target_properties(FFTW3::fftw3 PROPERTIES IMPORTED_LOCATION ${FFTW3_LIBRARY}
        INTERFACE_INCLUDE_DIRECTORIES ${FFTW3_INCLUDE_DIR})
    add_library(FFTW3::omp UNKNOWN IMPORTED)
    set_target_properties(FFTW3::omp PROPERTIES IMPORTED_LOCATION ${FFTW3_OMP_LIBRARY}
        INTERFACE_LINK_LIBRARIES FFTW3::fftw3)
endif()
mark_as_advanced(FFTW3_INCLUDE_DIR FFTW3_LIBRARY FFTW3_OMP_LIBRARY)

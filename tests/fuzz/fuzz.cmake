# The loader against changed files: twenty seconds of it in every test run, hours by hand (README.md).
add_executable(fuzz_gltf
  ${CMAKE_CURRENT_LIST_DIR}/fuzz_gltf.cpp ${CMAKE_CURRENT_LIST_DIR}/mutate.cpp
  ${CMAKE_CURRENT_LIST_DIR}/oracle.cpp)
target_link_libraries(fuzz_gltf PRIVATE
  scenes draco::draco meshoptimizer::meshoptimizer PkgConfig::webp ZLIB::ZLIB)
add_test(NAME fuzz.gltf COMMAND fuzz_gltf --seconds 20 --corpus ${CMAKE_CURRENT_LIST_DIR}/corpus)
set_tests_properties(fuzz.gltf PROPERTIES TIMEOUT 180)

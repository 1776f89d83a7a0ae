# The program's frame against the same frame by hand: pictures must agree, times are told.
add_executable(baseline baseline/main.cpp baseline/capture.cpp baseline/by_hand_opengl.cpp
  baseline/by_hand_vulkan.cpp baseline/by_hand_vulkan_objects.cpp)
target_link_libraries(baseline PRIVATE
  null_backend opengl_backend vulkan_backend rhi techniques shaders harness scenes)
foreach(api vulkan opengl)
  add_test(NAME baseline.${api} COMMAND baseline ${api} 50 1)
endforeach()

# Techniques: their rules and invariants on the drivers, their passes and numbers without.
target_sources(gpu_tests PRIVATE
  ${CMAKE_CURRENT_LIST_DIR}/cell.cpp
  ${CMAKE_CURRENT_LIST_DIR}/coloured_transparency_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/composited_translucent_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/concave_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/cssm1_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/cssm2_expectation_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/cssm2_rule_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/edge_buffers_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/filter_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/free_camera_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/generic_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/hash_gpu_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/identity_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/layer_probe.cpp
  ${CMAKE_CURRENT_LIST_DIR}/light_loop_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/local_lights_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/medium_gpu_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/noise_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/motion_gpu_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/penumbra_wedge_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/pictures_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/receiver_layers_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/shadow_culling_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/shadow_map_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/shadow_volume_limits_test.cpp ${CMAKE_CURRENT_LIST_DIR}/shadow_volume_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/sorted_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/steady_frames_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/stochastic_shadow_map_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/tracer.cpp
  ${CMAKE_CURRENT_LIST_DIR}/translucent_shadows_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/transparency_exact_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/transparency_limits_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/transparency_pictures_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/transparency_scenes.cpp
  ${CMAKE_CURRENT_LIST_DIR}/transparency_stochastic_test.cpp)
target_link_libraries(gpu_tests PRIVATE reports)
target_sources(unit_tests PRIVATE
  ${CMAKE_CURRENT_LIST_DIR}/cell.cpp
  ${CMAKE_CURRENT_LIST_DIR}/concave_sides_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/coverage_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/scene_tree_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/volume_bounds_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/edge_mesh_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/graph_levels_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/hash_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/light_area_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/light_views_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/media_plan_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/medium_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/noise_tiles_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/motion_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/penumbra_passes_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/plan_glass_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/plan_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/volume_geometry_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/wedge_test.cpp)

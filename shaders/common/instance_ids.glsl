#ifndef INSTANCE_IDS_GLSL
#define INSTANCE_IDS_GLSL
// The instance at hand, in fragment shaders.
layout(location = 5) flat in uvec4 v_ids;  // InstanceData::ids

#define INSTANCE v_ids.x
#define INSTANCE_KEY v_ids.y
#define INSTANCE_FIRST_TRIANGLE v_ids.z
#define INSTANCE_MESH_KEY v_ids.w
#endif

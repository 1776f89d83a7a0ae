#version 450
// The same where only geometry shaders pick layers.
layout(triangles, invocations = 3) in;
layout(triangle_strip, max_vertices = 3) out;
layout(location = 5) flat in uvec4 v_ids[];
layout(location = 5) flat out uvec4 g_ids;

void main() {
  for (int i = 0; i < 3; ++i) {
    gl_Position = gl_in[i].gl_Position;
    gl_PrimitiveID = gl_PrimitiveIDIn;  // concave sides hang on it
    gl_Layer = gl_InvocationID;
    g_ids = v_ids[i];
    EmitVertex();
  }
  EndPrimitive();
}

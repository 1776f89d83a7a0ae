#version 450
// The same where only geometry shaders pick layers, with what surfaces carry.
layout(triangles, invocations = 3) in;
layout(triangle_strip, max_vertices = 3) out;
layout(location = 3) in vec4 v_uv[];
layout(location = 4) in vec4 v_color[];
layout(location = 3) out vec4 g_uv;
layout(location = 4) out vec4 g_color;
layout(location = 5) flat in uvec4 v_ids[];
layout(location = 5) flat out uvec4 g_ids;
layout(location = 6) flat out uint g_channel;

void main() {
  for (int i = 0; i < 3; ++i) {
    gl_Position = gl_in[i].gl_Position;
    gl_PrimitiveID = gl_PrimitiveIDIn;  // keys of triangles hang on it
    gl_Layer = gl_InvocationID;
    g_uv = v_uv[i];
    g_color = v_color[i];
    g_ids = v_ids[i];
    g_channel = uint(gl_InvocationID);
    EmitVertex();
  }
  EndPrimitive();
}

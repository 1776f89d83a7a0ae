#version 450
layout(triangles) in;
layout(triangle_strip, max_vertices = 9) out;
layout(location = 0) in vec4 vertexColor[];
layout(location = 0) out vec4 geometryColor;
void main() {
  for (int layer = 0; layer < 3; ++layer) {
    for (int i = 0; i < 3; ++i) {
      gl_Position = gl_in[i].gl_Position;
      gl_Layer = layer;
      geometryColor = vertexColor[i] * float(layer + 1);
      EmitVertex();
    }
    EndPrimitive();
  }
}

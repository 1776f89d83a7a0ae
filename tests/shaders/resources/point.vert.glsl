#version 450
void main() {
  gl_Position = vec4(0.0, 0.0, 0.5, 1.0);
  gl_PointSize = 8.0;
}

#version 450
// log[frame] = value of this frame, read from a buffer that the command list wrote.
layout(local_size_x = 1) in;
layout(binding = 8, std430) readonly buffer In { uint frameValue; };
layout(binding = 9, std430) buffer Out { uint count; uint log[]; };
void main() { log[count++] = frameValue; }

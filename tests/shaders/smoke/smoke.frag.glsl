#version 450
layout(constant_id = 3) const bool kFlag = true;
layout(binding = 24) uniform sampler2D tex;
layout(binding = 8, std430) readonly buffer B { vec4 values[]; };
layout(location = 0) out vec4 color;
void main() { color = kFlag ? texture(tex, vec2(0.5)) : values[0]; }

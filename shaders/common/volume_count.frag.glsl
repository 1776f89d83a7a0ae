#version 450
// One more volume entered, or one less, into a float.
layout(constant_id = 18) const bool kFrontAdds = true;
layout(location = 0) out vec4 o_count;
void main() { o_count = vec4(gl_FrontFacing == kFrontAdds ? 1.0 : -1.0, 0, 0, 0); }

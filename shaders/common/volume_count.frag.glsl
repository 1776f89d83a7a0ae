#version 450
// One more volume entered, or one less, into a float.
layout(constant_id = 18) const bool kFrontAdds = true;
layout(location = 0) out float o_count;
void main() { o_count = gl_FrontFacing == kFrontAdds ? 1.0 : -1.0; }

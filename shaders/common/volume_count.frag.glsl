#version 450
// One more volume entered, or one less, into a float; or into bytes, those entered and those left.
layout(constant_id = 18) const bool kFrontAdds = true;
layout(constant_id = 19) const bool kBytes = false;
layout(location = 0) out vec4 o_count;
void main() {
  bool adds = gl_FrontFacing == kFrontAdds;
  o_count = kBytes ? vec4(adds ? 1 : 0, adds ? 0 : 1, 0, 0) / 255.0 : vec4(adds ? 1 : -1, 0, 0, 0);
}

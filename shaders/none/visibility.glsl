// No shadows: every light arrives whole. The baseline of every cost.
vec3 lightVisibility(uint light, Receiver r) { return vec3(1); }

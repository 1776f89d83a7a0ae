#version 450
layout(location = 0) out float o_count;
void main() { o_count = 1.0; }

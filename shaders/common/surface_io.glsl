// What a surface's vertex shader hands to its fragment shader. Define SURFACE_IO as `out` or `in`.
layout(location = 0) SURFACE_IO vec3 v_position;  // camera-relative
layout(location = 1) SURFACE_IO vec3 v_normal;    // world, not normalised
layout(location = 2) SURFACE_IO vec4 v_tangent;   // world, not normalised; w: handedness
layout(location = 3) SURFACE_IO vec4 v_uv;        // two sets
layout(location = 4) SURFACE_IO vec4 v_color;     // linear RGBA

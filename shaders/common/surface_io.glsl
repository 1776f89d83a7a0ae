// What a surface's vertex shader hands to its fragment shader. Define SURFACE_IO as `out` or `in`.
layout(location = 0) SURFACE_IO vec3 v_position;  // camera-relative
layout(location = 1) SURFACE_IO vec3 v_normal;    // world, not normalised
layout(location = 2) SURFACE_IO vec4 v_tangent;   // world, not normalised; w: handedness
layout(location = 3) SURFACE_IO vec4 v_uv;        // two sets
layout(location = 4) SURFACE_IO vec4 v_color;     // linear RGBA
layout(location = 6) flat SURFACE_IO uint v_firstOrdered;  // base into the triangle order
layout(location = 7) flat SURFACE_IO vec3 v_normalRow0;    // rows of the instance's cofactors
layout(location = 8) flat SURFACE_IO vec3 v_normalRow1;
layout(location = 9) flat SURFACE_IO vec3 v_normalRow2;

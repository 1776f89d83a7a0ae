// Which binding slot holds what. Flat Vulkan numbers: uniform 0.., storage 8.., textures 24..,
// images 56.. (backends/rhi/types.h). Techniques use the ranges that are theirs and no others.
#ifndef SHADOWBENCH_SHARED_SLOTS_H
#define SHADOWBENCH_SHARED_SLOTS_H

#define SLOT_UNIFORM(i) (i)
#define SLOT_STORAGE(i) (8 + (i))
#define SLOT_TEXTURE(i) (24 + (i))
#define SLOT_IMAGE(i) (56 + (i))

#define UNIFORM_MATERIAL 0
#define UNIFORM_FRAME 1
#define UNIFORM_TECHNIQUE 2     // the shadow technique's block
#define UNIFORM_TRANSPARENCY 3  // the transparency technique's block
#define UNIFORM_PASS 4          // parameters of one pass (light index, layer, ...)
#define UNIFORM_LIGHTS 5
#define UNIFORM_SHADOW_VIEWS 6
#define UNIFORM_MEDIA 7         // MediaBlock, where the plan runs participating media

#define STORAGE_LIGHT_LOOP 0     // 0, 1: of the light technique
#define STORAGE_LIGHTS 2
#define STORAGE_SHADOW_VIEWS 3
#define STORAGE_TRIANGLES 4
#define STORAGE_TRIANGLE_ORDER 5
#define STORAGE_TECHNIQUE 6      // 6..10
#define STORAGE_TRANSPARENCY 11  // 11..14
#define STORAGE_COPLANAR 15

#define TEXTURE_MATERIAL 0       // 0..6, MATERIAL_TEXTURES of them
#define TEXTURE_PREVIOUS_LAYER 7
#define TEXTURE_TECHNIQUE 8      // 8..19
#define TEXTURE_TRANSPARENCY 20  // 20..31

#define IMAGE_TECHNIQUE 0     // 0..3
#define IMAGE_TRANSPARENCY 4  // 4..7

#endif

// SPDX-License-Identifier: MIT
// The numbers of render/frame_context.h.
#define FRAME_BINDING 0
#define LIGHT_BINDING 2
#define INSTANCE_STORAGE 0
#define MATERIAL_STORAGE 1
#define TRIANGLE_STORAGE 2
#define EXCLUSION_STORAGE 7
#define UNIT_DEPTH 0
#define UNIT_SURFACE 1
#define UNIT_MATERIAL 2
#define UNIT_BASE_COLOR 16
#define UNIT_NORMAL_MAP 17
#define UNIT_HEIGHT 18
#define UNIT_METALLIC_ROUGHNESS 19
#define UNIT_EMISSIVE 20

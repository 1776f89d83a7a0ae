// What C++ and GLSL know of linked lists on the device.
#ifndef SHADOWBENCH_SHARED_LISTS_H
#define SHADOWBENCH_SHARED_LISTS_H

// No node follows; the head of an empty list.
#define END_OF_LIST 0xFFFFFFFFu

#endif

#pragma once

// Marks what the shared library osgLego shows to its users; everything else in it stays hidden.
#if defined(_WIN32)
#if defined(osgLego_EXPORTS)
#define OSGLEGO_EXPORT __declspec(dllexport)
#else
#define OSGLEGO_EXPORT __declspec(dllimport)
#endif
#else
#define OSGLEGO_EXPORT __attribute__((visibility("default")))
#endif

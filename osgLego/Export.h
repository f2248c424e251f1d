#pragma once

// Marks the symbols that the shared library osgLego exports; all others stay hidden.
#if defined(_WIN32)
#if defined(osgLego_EXPORTS)
#define OSGLEGO_EXPORT __declspec(dllexport)
#else
#define OSGLEGO_EXPORT __declspec(dllimport)
#endif
#else
#define OSGLEGO_EXPORT __attribute__((visibility("default")))
#endif

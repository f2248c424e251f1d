#pragma once

// Marks the symbols that the shared library osgLegoBooklet exports; all others stay hidden.
#if defined(_WIN32)
#if defined(osgLegoBooklet_EXPORTS)
#define OSGLEGOBOOKLET_EXPORT __declspec(dllexport)
#else
#define OSGLEGOBOOKLET_EXPORT __declspec(dllimport)
#endif
#else
#define OSGLEGOBOOKLET_EXPORT __attribute__((visibility("default")))
#endif

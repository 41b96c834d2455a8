// What of the shared libraries others see. They are compiled with hidden visibility: what a header does not mark is
// the library's own, and neither shown to a program nor taken from one.
#pragma once

/// Marks a class or a function that a program may link to. A marked class shows its members, those of its nested
/// classes too, but for nested classes marked UHAS_PRIVATE.
#if defined(__GNUC__)
#define UHAS_API __attribute__((visibility("default")))
#define UHAS_PRIVATE __attribute__((visibility("hidden")))
#else
#define UHAS_API
#define UHAS_PRIVATE
#endif

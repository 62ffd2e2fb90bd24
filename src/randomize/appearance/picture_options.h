#pragma once

namespace synthetic_dataset::randomize {

/// Values in settings that select synthesized pictures in place of a folder.
inline const char* const kProcedural = "procedural";  ///< patterns, by drawPattern()
inline const char* const kNatural = "natural";        ///< pictures of a NaturalPool

}  // namespace synthetic_dataset::randomize

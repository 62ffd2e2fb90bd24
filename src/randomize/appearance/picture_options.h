#pragma once

namespace synthetic_dataset::randomize {

/// In settings, in place of a folder of pictures: such as are made up.
inline const char* const kProcedural = "procedural";  ///< patterns, by drawPattern()
inline const char* const kNatural = "natural";        ///< pictures of a NaturalPool

}  // namespace synthetic_dataset::randomize

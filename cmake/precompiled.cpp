// Empty: CMake needs a source file for a target with precompiled headers (Precompiled.cmake).

// Empty: CMake wants a source for the headers that it precompiles (Precompiled.cmake).

// What the folders around the engine include of other libraries is precompiled with this file (CMakeLists.txt).

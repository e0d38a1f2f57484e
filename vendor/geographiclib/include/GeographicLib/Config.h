// The configuration of the GeographicLib that shoal compiles itself. Its namespace is another than
// that of an installed GeographicLib, so that a program can use both.
#define GEOGRAPHICLIB_VERSION_MAJOR 2
#define GEOGRAPHICLIB_VERSION_MINOR 1
#define GEOGRAPHICLIB_VERSION_PATCH 2
#define GEOGRAPHICLIB_VERSION_STRING "2.1.2"
#define GEOGRAPHICLIB_SHARED_LIB 0
#define GeographicLib shoal_geographiclib

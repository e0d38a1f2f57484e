// The viewer: a web server that shows a mission. See shoal-viewer --help.
#include "apps/viewer/viewer_app.h"
#include "apps/viewer/viewer_options.h"

int main(int argc, char** argv) {
  return shoal::RunViewer(shoal::ParseViewerOptionsOrExit(argc, argv));
}

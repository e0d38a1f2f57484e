#include "lib/tools/page/page_script.h"

#include <gtest/gtest.h>

#include <array>

namespace shoal {

TEST(OneScript, LeavesOutImportsAndExports) {
  constexpr std::array<std::string_view, 2> kModules = {
      "export const a = 1;\nexport function f() {\n  return 'import x';\n}\n",
      "import {a,\n  f} from './a.js';\nimport {b} from './b.js';\nconst c = f(a);\n"};
  EXPECT_EQ(OneScript(kModules),
            "'use strict';\n(() => {\nconst a = 1;\nfunction f() {\n  return 'import x';\n}\n"
            "const c = f(a);\n})();\n");
}

TEST(OneScript, GivesUplotAScopeOfItsOwn) {
  constexpr std::array<std::string_view, 2> kModules = {
      "function uPlot() {}\nconst a = 1;\nexport { uPlot as default };\n",
      "import uPlot from './uPlot.esm.js';\nconst a = uPlot();"};
  EXPECT_EQ(OneScript(kModules),
            "'use strict';\n(() => {\nconst uPlot = (() => {\nfunction uPlot() {}\nconst a = 1;\n"
            "return uPlot;\n})();\nconst a = uPlot();})();\n");
}

TEST(ScriptHash, IsThatOfThePublishedExample) {
  // "alert('Hello, world.');": Content Security Policy Level 3, 2.3.1 and 6.7.3.3.
  EXPECT_EQ(ScriptHash("alert('Hello, world.');"),
            "'sha256-qznLcsROx4GACP2dm0UCKCzCG+HiZ1guq6ZZDob/Tng='");
}

}  // namespace shoal

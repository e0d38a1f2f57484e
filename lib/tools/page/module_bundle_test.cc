#include "lib/tools/page/module_bundle.h"

#include <gtest/gtest.h>

namespace shoal::module_bundle_test {

TEST(ModuleBundle, PutsEachModuleBehindThoseThatItImportsInAScopeOfItsOwn) {
  const auto bundle = BundleModules(
      ModuleTexts(
          {{"/app.js",
            "import {b as c,\n  D} from './net/b.js';\nimport u from './u.js';\nc(u);\n"},
           {"/net/b.js",
            "import u from '../u.js';\nexport const b = u;\nexport class D {}\n"
            "export async function wait() {}\n"},
           {"/u.js",
            "/*\nexport function v() {}\n*/\nfunction u() {}\nexport { u as default };\n"}}),
      "/app.js");
  ASSERT_TRUE(bundle.ok()) << bundle.error();
  EXPECT_EQ(*bundle,
            "const module1 = (() => {\n/*\nexport function v() {}\n*/\nfunction u() {}\nreturn "
            "{default: u, };\n})();\n"
            "const module2 = (() => {\nconst u = module1.default;\nconst b = u;\nclass D {}\n"
            "async function wait() {}\nreturn {b, D, wait, };\n})();\n"
            "const module3 = (() => {\nconst {b: c,\n  D} = module2;\nconst u = module1.default;\n"
            "c(u);\nreturn {};\n})();\n");
}

TEST(ModuleBundle, NamesAModuleThatIsMissingOrImportsItself) {
  EXPECT_EQ(BundleModules(ModuleTexts({{"/a.js", "import {b} from './b.js';\n"}}), "/a.js").error(),
            "the page has no /b.js");
  EXPECT_EQ(BundleModules(ModuleTexts({{"/a.js", "import {b} from './b.js';\n"},
                                       {"/b.js", "import {a} from './a.js';\n"}}),
                          "/a.js")
                .error(),
            "/a.js imports itself, by others");
  EXPECT_EQ(BundleModules(ModuleTexts({{"/a.js", "import './b.js';\n"}}), "/a.js").error(),
            "/a.js: an import of another form: import './b.js';\n");
}

}  // namespace shoal::module_bundle_test

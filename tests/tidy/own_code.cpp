// A plugin of clang-tidy: the checks look at the declarations of our sources only. What they find in a system header is
// never shown, but clang-tidy 14 searches all of them, which takes most of its time.
#include <clang-tidy/ClangTidyCheck.h>
#include <clang-tidy/ClangTidyModule.h>
#include <clang-tidy/ClangTidyModuleRegistry.h>

namespace {

using namespace clang;

class OwnCode : public tidy::ClangTidyCheck {
 public:
  using ClangTidyCheck::ClangTidyCheck;
  void registerMatchers(ast_matchers::MatchFinder* finder) override {
    finder->addMatcher(ast_matchers::translationUnitDecl().bind("all"), this);
  }
  // The whole is asked before its parts are, and the parts are taken from this list.
  void check(const ast_matchers::MatchFinder::MatchResult& result) override {
    std::vector<Decl*> ours;
    for (Decl* each : result.Context->getTranslationUnitDecl()->decls())
      if (!result.SourceManager->isInSystemHeader(result.SourceManager->getExpansionLoc(each->getLocation())))
        ours.push_back(each);
    result.Context->setTraversalScope(ours);
  }
};

class OwnCodeModule : public tidy::ClangTidyModule {
 public:
  void addCheckFactories(tidy::ClangTidyCheckFactories& checks) override {
    checks.registerCheck<OwnCode>("fyd-own-code");
  }
};

const tidy::ClangTidyModuleRegistry::Add<OwnCodeModule> kModule("fyd", "The checks look at our declarations only");

}  // namespace

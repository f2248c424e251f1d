#include <osgLego/ModelDesigner.h>

#include <osgLego/BuildingPlanner.h>
#include <osgLego/CpuLegolizer.h>
#include <osgLego/Stability.h>
#include <osgLego/design/DesignRanking.h>

#include <common/RacingCar.h>

#include <Meshes.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include <gtest/gtest.h>
#include <osg/ShapeDrawable>

namespace osgLego
{

namespace
{

/** A white box with its middle at the origin. */
osg::ref_ptr<osg::Node> makeBox(const osg::Vec3& size)
{
    return new osg::ShapeDrawable(new osg::Box(osg::Vec3(), size.x(), size.y(), size.z()));
}

/** The design of a mesh by settings in their text form. */
std::optional<ModelDesign> designWith(const std::string& settings, const osg::Node& node)
{
    DesignOptions options;
    options.settings = settings;
    std::string error;
    std::optional<ModelDesign> design = designModel(node, options, error);
    EXPECT_EQ(error, "");
    return design;
}

std::string errorOf(const osg::Node& node, const DesignOptions& options)
{
    std::string error;
    EXPECT_FALSE(designModel(node, options, error));
    return error;
}

TEST(ModelDesigner, TheCarBecomesOnePieceThatStands)
{
    DesignOptions options;
    options.numParts = 80;
    std::string error;
    const std::optional<ModelDesign> design = designModel(*createRacingCar(), options, error);
    ASSERT_TRUE(design) << error;
    const DesignCandidate& best = design->getBest();
    EXPECT_TRUE(best.isWhole());
    EXPECT_TRUE(computeStability(*best.model)->safe);
    EXPECT_LE(best.model->getParts().size(), 80u);
    EXPECT_GE(best.model->getParts().size(), 50u);
    EXPECT_GE(design->candidates.size() + design->numOthers, 4u);
    for (const DesignCandidate& candidate : design->candidates)
    {
        EXPECT_EQ(candidate.layout.numParts, candidate.model->getParts().size());
        const bool isSafe = candidate.isSound() && candidate.stability.safe;
        EXPECT_TRUE(!isSafe || candidate.getError() > best.getError() - 0.01) << candidate.settings.toString();
    }
}

TEST(ModelDesigner, SettingsThatMakeNoModelWouldMakeNoBetterOne)
{
    const osg::ref_ptr<osg::Node> car = createRacingCar();
    DesignOptions options;
    options.numParts = 60; // with 120, the draft of each setting is so much like the mesh that its model is made
    options.settings = "colors=8";
    std::string error;
    const std::optional<ModelDesign> design = designModel(*car, options, error);
    ASSERT_TRUE(design) << error;
    EXPECT_GT(design->numOthers, 0u);
    EXPECT_LE(design->numOthers + design->candidates.size(), 7u) << "six settings, and a lower resolution";
    const std::string text = design->toString();
    EXPECT_NE(text.find("no models were made by " + std::to_string(design->numOthers) + " other setting"),
              std::string::npos)
        << text;
    for (const char* proportions : {"brick", "plate"})
        for (const char* fill : {"surface", "shell", "solid"})
        {
            options.settings = std::string("proportions=") + proportions + ",colors=8,fill=" + fill;
            const std::optional<ModelDesign> other = designModel(*car, options, error);
            ASSERT_TRUE(other) << error;
            const DesignCandidate& best = other->getBest();
            const bool isGood = best.isSound() && best.stability.safe && !best.exceedsLimits();
            EXPECT_TRUE(!isGood || best.getError() > design->getBest().getError() - 0.01) << options.settings;
        }
}

TEST(ModelDesigner, TheSettingsMakeTheSameModel)
{
    DesignOptions options;
    options.numParts = 40;
    options.settings = "fill=solid,proportions=brick";
    options.base = BuildingBase::PLATE;
    options.view = {213.0, 30.0}; // from behind
    const osg::ref_ptr<osg::Node> car = createRacingCar();
    std::string error;
    const std::optional<ModelDesign> design = designModel(*car, options, error);
    ASSERT_TRUE(design) << error;
    for (const DesignCandidate& candidate : design->candidates)
    {
        EXPECT_EQ(candidate.settings.parts.fill, Fill::SOLID);
        EXPECT_EQ(candidate.settings.grid.proportions, Proportions::BRICK);
        EXPECT_EQ(legolizeOnCpu(*car, candidate.settings)->getParts(), candidate.model->getParts());
    }
    // So that a booklet with this view and base needs no other plan.
    const DesignCandidate& best = design->getBest();
    PlanningOptions planning;
    planning.base = options.base;
    planning.view = options.view;
    ASSERT_TRUE(best.plan);
    EXPECT_EQ(best.plan->getSteps(), planBuilding(*best.model, planning)->getSteps());
    planning.view = {};
    EXPECT_NE(best.plan->getSteps(), planBuilding(*best.model, planning)->getSteps());
}

TEST(ModelDesigner, ALengthIsThatOfTheLongestSideWhicheverItIs)
{
    // 3 x 1 x 1 and 1 x 1 x 3, in bricks 9.6 mm high and plates 3.2 mm high.
    for (const bool isTall : {false, true})
        for (const char* proportions : {"proportions=brick", "proportions=plate"})
        {
            const osg::ref_ptr<osg::Node> box = makeBox(isTall ? osg::Vec3(1, 1, 3) : osg::Vec3(3, 1, 1));
            DesignOptions options;
            options.length = 96.0;
            options.settings = proportions;
            std::string error;
            const std::optional<ModelDesign> design = designModel(*box, options, error);
            ASSERT_TRUE(design) << error;
            const glm::dvec3 size = design->getBest().layout.size;
            EXPECT_NEAR(std::max({size.x, size.y, size.z}), 96.0, 9.6) << proportions << isTall;
            EXPECT_NEAR(isTall ? size.z : size.x, 96.0, 9.6) << proportions;
        }
}

/** A table with one leg at its end. */
osg::ref_ptr<osg::Node> createOneLeggedTable()
{
    osg::ref_ptr<osg::Group> table = new osg::Group;
    table->addChild(new osg::ShapeDrawable(new osg::Box(osg::Vec3(0, 0, 5.5f), 12, 3, 0.9f)));
    table->addChild(new osg::ShapeDrawable(new osg::Box(osg::Vec3(-5.4f, 0, 2.5f), 0.9f, 2.9f, 5)));
    return table;
}

TEST(ModelDesigner, ASupportedModelHasFewEnoughParts)
{
    // Supported at the highest resolutions that have few enough parts without, all models would have more.
    DesignOptions options;
    options.numParts = 30;
    options.settings = "proportions=brick,fill=surface,colors=8";
    std::string error;
    const std::optional<ModelDesign> design = designModel(*createOneLeggedTable(), options, error);
    ASSERT_TRUE(design) << error;
    EXPECT_TRUE(design->getBest().isSound());
    EXPECT_TRUE(design->getBest().settings.parts.support);
    EXPECT_LE(design->getBest().layout.numParts, 30u) << design->toString();
}

TEST(DesignRanking, FewEnoughPartsMatterMoreThanLikenessButLessThanStability)
{
    const auto create = [](std::size_t numParts, double error)
    {
        DesignCandidate candidate;
        candidate.numPieces = 1;
        candidate.stability.stands = true;
        candidate.stability.safe = true;
        candidate.layout.numParts = numParts;
        candidate.surfaceError = error;
        return candidate;
    };
    const DesignRanking ranking(200);
    const DesignCandidate few = create(188, 0.08);
    const DesignCandidate many = create(219, 0.05);
    ASSERT_LT(many.getError(), few.getError());
    EXPECT_TRUE(ranking.isBetter(few, many));
    EXPECT_FALSE(ranking.isBetter(many, few));
    EXPECT_TRUE(DesignRanking(300).isBetter(many, few));
    DesignCandidate falling = few;
    falling.stability.stands = false;
    EXPECT_TRUE(ranking.isBetter(many, falling));
}

TEST(DesignRanking, AModelWithItsGapsMayBeFartherFromTheMeshThanOneThatClosesThem)
{
    DesignCandidate closed;
    closed.surfaceError = 0.009;
    closed.lostSurface = 0.03;
    DesignCandidate open;
    open.surfaceError = 0.013;
    const DesignRanking ranking(200);
    EXPECT_TRUE(ranking.isBetter(open, closed));
    open.surfaceError = 0.02;
    EXPECT_TRUE(ranking.isBetter(closed, open));
}

TEST(DesignRanking, OfEqualModelsThatWithTheFewestSettingsComesFirst)
{
    DesignCandidate plain;
    DesignCandidate colored;
    colored.settings.colors.count = 8;
    const DesignRanking ranking(200);
    EXPECT_TRUE(ranking.isBetter(plain, colored));
    EXPECT_FALSE(ranking.isBetter(colored, plain));
}

TEST(ModelDesign, AModelWhosePartsAreMostlyInOneSubmodelIsNotCalledEasyToBuild)
{
    const auto describe = [](std::uint32_t numInSubmodel)
    {
        constexpr std::uint32_t NUM_PARTS = 12;
        std::vector<std::uint32_t> parts(NUM_PARTS);
        std::iota(parts.begin(), parts.end(), 0u);
        BuildingStep attached;
        attached.parts.assign(parts.begin() + numInSubmodel, parts.end());
        attached.submodels = {0};
        BuildingStep inner;
        inner.parts.assign(parts.begin(), parts.begin() + numInSubmodel);
        DesignCandidate candidate;
        candidate.numPieces = 1;
        candidate.layout.numParts = NUM_PARTS;
        candidate.plan = BuildingPlan::create(NUM_PARTS, {attached}, {{{inner}}});
        return ModelDesign{{candidate, candidate}}.toString();
    };
    EXPECT_NE(describe(6).find("and are easy to build"), std::string::npos);
    EXPECT_EQ(describe(7).find("and are easy to build"), std::string::npos);
    EXPECT_NE(describe(7).find("most parts are in one submodel"), std::string::npos);
    EXPECT_NE(describe(7).find(" 7x1 "), std::string::npos) << describe(7);
}

TEST(ModelDesign, TheListSaysWhichModelsHaveNoSubmodelsAndWhichNoPlan)
{
    DesignCandidate planned;
    planned.plan = BuildingPlan::create(0, {}, {});
    const std::string text = ModelDesign{{planned, DesignCandidate()}}.toString();
    EXPECT_NE(text.find(" none    0 "), std::string::npos) << text;
    EXPECT_NE(text.find(" -    - "), std::string::npos) << text;
}

TEST(ModelDesigner, AModelThatFallsIsSupported)
{
    const std::optional<ModelDesign> design =
        designWith("12,proportions=brick,fill=surface,colors=8", *createOneLeggedTable());
    ASSERT_TRUE(design);
    EXPECT_TRUE(design->getBest().isSound());
    EXPECT_TRUE(design->getBest().settings.parts.support);
    EXPECT_TRUE(std::any_of(design->candidates.begin(), design->candidates.end(),
                            [](const DesignCandidate& candidate) { return candidate.stability.falls(); }))
        << "the model without support belongs in the comparison";
    const std::string text = design->toString();
    EXPECT_NE(text.find("chosen: " + design->getBest().settings.toString()), std::string::npos);
    EXPECT_NE(text.find("support=on"), std::string::npos);
}

TEST(ModelDesigner, AModelThatFallsIsNotSupportedIfItsPiecesMustNotBeJoined)
{
    const std::optional<ModelDesign> design =
        designWith("12,proportions=brick,fill=surface,colors=8,connect=off", *createOneLeggedTable());
    ASSERT_TRUE(design);
    EXPECT_TRUE(design->getBest().stability.falls());
    for (const DesignCandidate& candidate : design->candidates)
        EXPECT_FALSE(candidate.settings.parts.support) << "support joins pieces";
}

TEST(DesignRanking, HardModelsAreThoseThatFallOrExceedTheLimitsBricksAndPlatesInTurns)
{
    const auto create = [](Proportions proportions, double error)
    {
        DesignCandidate candidate;
        candidate.numPieces = 1;
        candidate.stability.stands = false;
        candidate.surfaceError = error;
        candidate.settings.grid.proportions = proportions;
        return candidate;
    };
    std::vector<DesignCandidate> candidates;
    for (const double error : {0.1, 0.2})
        candidates.push_back(create(Proportions::PLATE, error));
    candidates.push_back(create(Proportions::BRICK, 0.3));
    for (std::size_t index = 0; index < candidates.size(); ++index)
        candidates[index].settings.grid.resolution = static_cast<unsigned int>(index + 1);
    const auto listResolutions = [](const std::vector<DesignCandidate>& all)
    {
        std::vector<unsigned int> resolutions;
        for (const LegoSettings& settings : DesignRanking::listHard(all))
            resolutions.push_back(settings.grid.resolution);
        return resolutions;
    };
    EXPECT_EQ(listResolutions(candidates), (std::vector<unsigned int>{1, 3, 2}));

    std::vector<DesignCandidate> others = candidates;
    others[0].settings.parts.support = true;
    others[1].numPieces = 2;
    EXPECT_EQ(listResolutions(others), std::vector<unsigned int>{3});
    others = candidates;
    for (DesignCandidate& candidate : others)
        candidate.stability.stands = true;
    EXPECT_TRUE(listResolutions(others).empty()) << "nothing is known of their building";
    BuildingStep all;
    all.parts.resize(BuildingPlan::MOST_SUBMODEL_PARTS + 1);
    std::iota(all.parts.begin(), all.parts.end(), 0u);
    BuildingStep attached;
    attached.submodels = {0};
    others[1].plan = BuildingPlan::create(all.parts.size(), {attached}, {{{all}}});
    others[2].plan = BuildingPlan::create(all.parts.size(), {all});
    EXPECT_EQ(listResolutions(others), std::vector<unsigned int>{2});
}

TEST(ModelDesigner, AModelThatIsEasyToBuildIsPreferredToColumnsBelowOneThatIsNot)
{
    DesignOptions options;
    options.numParts = 750;
    options.settings = "proportions=plate,colors=1";
    std::string error;
    const std::optional<ModelDesign> design = designModel(*test::createFourLeggedTable(), options, error);
    ASSERT_TRUE(design) << error;
    const DesignCandidate& best = design->getBest();
    EXPECT_TRUE(best.isSound());
    ASSERT_TRUE(best.plan);
    EXPECT_FALSE(best.exceedsLimits());
    EXPECT_TRUE(std::any_of(design->candidates.begin(), design->candidates.end(),
                            [](const DesignCandidate& candidate)
                            { return candidate.plan && candidate.exceedsLimits(); }))
        << design->toString();
    for (const DesignCandidate& candidate : design->candidates)
        EXPECT_FALSE(candidate.settings.parts.support) << design->toString();
}

TEST(ModelDesigner, AModelThatNeedsALargeSubmodelIsSupported)
{
    const std::optional<ModelDesign> design =
        designWith("68,proportions=brick,fill=solid,colors=1", *test::createBridge());
    ASSERT_TRUE(design);
    const DesignCandidate& best = design->getBest();
    EXPECT_TRUE(best.isSound());
    EXPECT_TRUE(best.settings.parts.support);
    ASSERT_TRUE(best.plan);
    EXPECT_FALSE(best.exceedsLimits());
    EXPECT_TRUE(planBuilding(*best.model)->keepsLimits());
    ASSERT_EQ(design->candidates.size(), 2u);
    EXPECT_TRUE(design->candidates[1].exceedsLimits());
    EXPECT_EQ(design->toString().find("hard to build"), std::string::npos);
    const std::string without = ModelDesign{{design->candidates[1]}}.toString();
    EXPECT_NE(without.find("hard to build: its largest submodel has "), std::string::npos) << without;
}

TEST(ModelDesigner, AModelThatNeedsALargeSubmodelIsNotSupportedIfItsPiecesMustNotBeJoined)
{
    const std::optional<ModelDesign> design =
        designWith("68,proportions=brick,fill=solid,colors=1,connect=off", *test::createBridge());
    ASSERT_TRUE(design);
    EXPECT_TRUE(design->getBest().exceedsLimits());
    EXPECT_FALSE(design->getBest().settings.parts.support);
}

TEST(ModelDesign, LargeModelsWhoseBuildingIsNotPlannedCountAsBeyondTheLimits)
{
    DesignCandidate candidate;
    candidate.numPieces = 1;
    candidate.layout.numParts = DesignCandidate::MOST_PLANNED_PARTS;
    EXPECT_FALSE(candidate.exceedsLimits());
    candidate.layout.numParts = DesignCandidate::MOST_PLANNED_PARTS + 1;
    EXPECT_TRUE(candidate.exceedsLimits());
    candidate.stability.stands = true;
    const std::string text = ModelDesign{{candidate}}.toString();
    EXPECT_NE(text.find("building: not planned, since the model has more than 2000 parts"), std::string::npos) << text;
}

TEST(ModelDesigner, OfModelsInPiecesOneThatStandsIsChosen)
{
    // The upper box touches nothing.
    const osg::ref_ptr<osg::Group> boxes = new osg::Group;
    boxes->addChild(new osg::ShapeDrawable(new osg::Box(osg::Vec3(0, 0, 1.5f), 4, 4, 3)));
    boxes->addChild(new osg::ShapeDrawable(new osg::Box(osg::Vec3(8, 0, 8.5f), 4, 4, 3)));
    DesignOptions options;
    options.settings = "12,proportions=brick,fill=surface,colors=8";
    std::string error;
    const std::optional<ModelDesign> design = designModel(*boxes, options, error);
    ASSERT_TRUE(design) << error;
    EXPECT_FALSE(design->getBest().isWhole());
    EXPECT_TRUE(design->getBest().stability.stands);
    EXPECT_TRUE(design->candidates.back().stability.falls());
    const std::string text = design->toString();
    EXPECT_NE(text.find("2 pieces that no part joins"), std::string::npos) << text;
    EXPECT_EQ(text.find("the model stands safely"), std::string::npos) << text;
}

TEST(ModelDesigner, ABasePlateJoinsThePiecesOfAFlatSheet)
{
    const osg::ref_ptr<osg::ShapeDrawable> sheet = new osg::ShapeDrawable(new osg::Box(osg::Vec3(), 12, 9, 0.1f));
    DesignOptions options;
    options.numParts = 40;
    options.settings = "proportions=plate,fill=surface,colors=8";
    for (const BuildingBase base : {BuildingBase::TABLE, BuildingBase::PLATE})
    {
        options.base = base;
        std::string error;
        const std::optional<ModelDesign> design = designModel(*sheet, options, error);
        ASSERT_TRUE(design) << error;
        EXPECT_EQ(design->getBest().isSound(), base == BuildingBase::PLATE) << design->toString();
        EXPECT_GT(design->getBest().layout.numComponents, 1u);
    }
}

/** A board of 8 x 8 squares. @param isUpright whether it stands on a side. */
osg::ref_ptr<osg::Node> createChessboard(bool isUpright)
{
    osg::ref_ptr<osg::Group> board = new osg::Group;
    for (int row = 0; row < 8; ++row)
        for (int column = 0; column < 8; ++column)
        {
            const float x = static_cast<float>(column) + 0.5f;
            const float y = static_cast<float>(row) + 0.5f;
            const osg::ref_ptr<osg::ShapeDrawable> square = new osg::ShapeDrawable(
                isUpright ? new osg::Box(osg::Vec3(x, 0, y), 1, 2, 1) : new osg::Box(osg::Vec3(x, y, 0), 1, 1, 0.1f));
            const float level = (row + column) % 2 == 0 ? 0.0f : 1.0f;
            square->setColor(osg::Vec4(level, level, level, 1.0f));
            board->addChild(square);
        }
    return board;
}

TEST(ModelDesigner, AnUprightChessboardHasOneCellForEachSquareIfTwoNeedTooManyParts)
{
    DesignOptions options;
    options.numParts = 200;
    options.settings = "proportions=plate,fill=shell,colors=8";
    std::string error;
    const std::optional<ModelDesign> design = designModel(*createChessboard(true), options, error);
    ASSERT_TRUE(design) << error;
    EXPECT_EQ(design->getBest().settings.grid.resolution, 8u) << design->toString();
    EXPECT_TRUE(std::any_of(design->candidates.begin(), design->candidates.end(),
                            [](const DesignCandidate& candidate) { return candidate.settings.grid.resolution > 8; }))
        << "the test needs a model of squares of one and two cells";
}

TEST(ModelDesigner, AnOddResolutionOfAChessboardIsNotTheBest)
{
    // 33 cells a side have few enough parts, and squares of four and five cells.
    DesignOptions options;
    options.numParts = 290;
    options.base = BuildingBase::PLATE;
    options.settings = "proportions=plate,fill=surface,colors=8";
    std::string error;
    const std::optional<ModelDesign> design = designModel(*createChessboard(false), options, error);
    ASSERT_TRUE(design) << error;
    EXPECT_EQ(design->getBest().settings.grid.resolution % 8, 0u) << design->toString();
    EXPECT_TRUE(std::any_of(design->candidates.begin(), design->candidates.end(),
                            [](const DesignCandidate& candidate)
                            { return candidate.settings.grid.resolution % 2 == 1; }))
        << "the test needs a highest resolution that is odd";
}

TEST(ModelDesigner, AChessboardOnABasePlateHasWholeCellsForEachSquareAndKeepsItsColors)
{
    // 21 cells a side would have as few parts, and squares of two and three cells.
    const osg::ref_ptr<osg::Node> board = createChessboard(false);
    DesignOptions options;
    options.numParts = 80;
    options.base = BuildingBase::PLATE;
    options.settings = "proportions=plate,fill=surface,colors=8";
    std::string error;
    const std::optional<ModelDesign> design = designModel(*board, options, error);
    ASSERT_TRUE(design) << error;
    const DesignCandidate& best = design->getBest();
    EXPECT_EQ(best.settings.grid.resolution, 16u) << design->toString();
    EXPECT_EQ(best.layout.numParts, 64u);
    EXPECT_FALSE(best.settings.parts.connect) << "the base plate joins the squares";
    EXPECT_NE(design->toString().find("the base plate joins these pieces; the model stands safely"), std::string::npos);
    EXPECT_LT(best.colorError, 5.0);
    ASSERT_EQ(design->candidates.size(), 2u);
    EXPECT_LT(best.getError(), 0.7 * design->candidates[1].getError());

    options.settings += ",connect=on";
    EXPECT_TRUE(designModel(*board, options, error)->getBest().settings.parts.connect) << "as wanted";
}

TEST(ModelDesigner, IfTheSizeIsGivenAModelOfFewEnoughPartsIsPreferred)
{
    const osg::ref_ptr<osg::Node> car = createRacingCar();
    DesignOptions options;
    options.settings = "11,fill=surface"; // in eight colours, the model has fewer parts
    std::string error;
    const std::optional<ModelDesign> unlimited = designModel(*car, options, error);
    ASSERT_TRUE(unlimited) << error;
    EXPECT_GT(unlimited->numOthers, 0u);
    std::size_t fewest = unlimited->getBest().layout.numParts;
    for (const DesignCandidate& candidate : unlimited->candidates)
        if (candidate.isSound() && candidate.stability.safe) fewest = std::min(fewest, candidate.layout.numParts);
    ASSERT_LT(fewest, unlimited->getBest().layout.numParts) << unlimited->toString();
    options.numParts = fewest;
    const std::optional<ModelDesign> limited = designModel(*car, options, error);
    EXPECT_EQ(limited->getBest().layout.numParts, fewest) << limited->toString();
    options.numParts = 1;
    const std::optional<ModelDesign> tooLarge = designModel(*car, options, error);
    EXPECT_EQ(tooLarge->getBest().layout.numParts, unlimited->getBest().layout.numParts);
    EXPECT_EQ(tooLarge->numOthers, 0u) << "one of them might have had few enough parts";
}

TEST(ModelDesigner, ALatticeMakesTheModelThatTheSettingsMake)
{
    DesignOptions options;
    options.settings = "10,proportions=brick,fill=surface,colors=8,anchor=model";
    const osg::ref_ptr<osg::Node> car = createRacingCar();
    std::string error;
    const std::optional<ModelDesign> design = designModel(*car, options, error);
    ASSERT_TRUE(design) << error;
    const DesignCandidate& best = design->getBest();
    const osg::ref_ptr<const BrickModel> made = legolizeOnCpu(*car, best.settings);
    EXPECT_EQ(made->getGrid(), best.model->getGrid());
    EXPECT_EQ(made->getParts(), best.model->getParts());
}

TEST(ModelDesigner, BadGoalsAreRefusedInOneSentence)
{
    const osg::ref_ptr<osg::Node> box = makeBox(osg::Vec3(1, 1, 1));
    DesignOptions options;
    options.numParts = 0;
    EXPECT_EQ(errorOf(*box, options), "the number of parts is out of range; expected 1 to 10000");
    options = {};
    options.length = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(errorOf(*box, options), "the length is out of range; expected 8 to 8192 millimetres");
    options = {};
    options.view.elevation = 85.0;
    EXPECT_EQ(errorOf(*box, options), "the view is out of range; expected 10 to 80 degrees of elevation");
    options = {};
    options.settings = "up=x";
    EXPECT_NE(errorOf(*box, options).find("up"), std::string::npos);
    for (const char* settings : {"parts=none", "parts=none,connect=off"})
    {
        options.settings = settings;
        EXPECT_EQ(errorOf(*box, options), "parts=none gives no parts; expected parts=bricks");
    }
    options.settings = "12";
    options.length = 100.0;
    EXPECT_EQ(errorOf(*box, options), "a length can't be combined with a resolution or a cell; expected either");
    options = {};
    const osg::ref_ptr<osg::Group> empty = new osg::Group;
    EXPECT_NE(errorOf(*empty, options).find("no visible triangles"), std::string::npos);
}

TEST(ModelDesigner, ACancelledDesignIsNone)
{
    DesignOptions options;
    options.isCancelled = [] { return true; };
    EXPECT_EQ(errorOf(*createRacingCar(), options), "");
}

TEST(ModelDesigner, TellsTheNumberOfPartsThatModelsShouldNotExceed)
{
    const osg::ref_ptr<osg::Node> box = makeBox(osg::Vec3(2, 1, 1));
    const auto findMostParts = [&](const std::string& settings, std::optional<std::size_t> numParts)
    {
        DesignOptions options;
        options.settings = settings;
        options.numParts = numParts;
        std::string error;
        return designModel(*box, options, error).value().mostParts;
    };
    EXPECT_EQ(findMostParts("6,colors=1", std::nullopt), std::nullopt);
    EXPECT_EQ(findMostParts("6,colors=1", 20), 20u);
    EXPECT_EQ(findMostParts("proportions=brick,fill=surface,colors=1", 20), 20u);
    EXPECT_EQ(findMostParts("proportions=brick,fill=surface,colors=1", std::nullopt), DesignOptions::USUAL_PARTS);
}

TEST(ModelDesigner, TheProgressGrowsToOne)
{
    DesignOptions options;
    options.numParts = 20;
    double last = 0.0;
    options.progress = [&last](double share)
    {
        EXPECT_GE(share, last);
        last = share;
    };
    std::string error;
    EXPECT_TRUE(designModel(*makeBox(osg::Vec3(2, 1, 1)), options, error)) << error;
    EXPECT_EQ(last, 1.0);
}

TEST(ModelDesigner, TheProgressGrowsWhileModelsAreSupported)
{
    DesignOptions options;
    options.settings = "12,proportions=brick,fill=surface,colors=8";
    std::vector<double> shares;
    options.progress = [&shares](double share) { shares.push_back(share); };
    std::string error;
    EXPECT_TRUE(designModel(*createOneLeggedTable(), options, error)) << error;
    // Other models have 60 %, and each supported one 3 %.
    EXPECT_GE(std::count_if(shares.begin(), shares.end(), [](double share) { return share > 0.601 && share < 0.63; }),
              5);
}

} // namespace

} // namespace osgLego

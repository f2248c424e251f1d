#include "Notices.h"

#include <osg/Notify>
#include <osg/ref_ptr>

namespace osgLego::test
{

namespace
{

class Notices : public osg::NotifyHandler
{
public:
    void notify(osg::NotifySeverity, const char* message) override { text += message; }
    std::string text;
};

} // namespace

std::string noticesOf(const std::function<void()>& function)
{
    const osg::ref_ptr<Notices> notices = new Notices;
    const osg::ref_ptr<osg::NotifyHandler> before = osg::getNotifyHandler();
    osg::setNotifyHandler(notices);
    function();
    osg::setNotifyHandler(before);
    return notices->text;
}

} // namespace osgLego::test

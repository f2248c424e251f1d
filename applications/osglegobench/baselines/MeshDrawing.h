#pragma once

#include <osgLego/flattening/GridTriangles.h>
#include <osgLego/gl/GlObject.h>

#include <vector>

#include <osg/State>
#include <osg/Texture2D>
#include <osg/ref_ptr>

namespace osgLego
{

/** Takes the triangles of a mesh to the GPU and draws them, with what shaders/passes/surface_color.glsl wants. */
class MeshDrawing
{
public:
    /** Make the textures of the surfaces, and buffers for triangles, empty as yet. */
    void create(osg::State& state, const GridTriangles& triangles);
    /** Copy all of the triangles into the buffers. */
    void upload(const osg::State& state) const;
    /** Draw them by the program that the state has applied. */
    void draw(osg::State& state) const;
    void release();

private:
    struct Batch
    {
        const GridBatch* source = nullptr;
        GlBuffer buffer;
        osg::ref_ptr<osg::Texture2D> texture;
    };

    osg::ref_ptr<const GridTriangles> _triangles;
    std::vector<Batch> _batches;
};

} // namespace osgLego

package org.echoway.sdkless;
final class Apk { Apk(Workspace w){} void build(java.nio.file.Path p){} }

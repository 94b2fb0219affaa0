pluginManagement {
    repositories {
        google()
        mavenCentral()
        gradlePluginPortal()
    }
}

dependencyResolutionManagement {
    repositoriesMode = RepositoriesMode.FAIL_ON_PROJECT_REPOS
    repositories {
        google()
        mavenCentral()
    }
}

rootProject.name = "glide-slam-android"

// The name of the archive and of its prefab package, as ./glide aar has them.
include(":glide-slam", ":sample")
project(":glide-slam").projectDir = file("glide")

// What Gradle generates for a script: its plugins' extensions, and functions that take them. Names and types are
// checked against Gradle's and the Android Gradle Plugin's own API; how a script behaves when it runs is not.
@file:Suppress("UNUSED_PARAMETER")

import com.android.build.api.dsl.ApplicationExtension
import com.android.build.api.dsl.LibraryExtension
import org.gradle.api.Project
import org.gradle.api.artifacts.dsl.RepositoryHandler
import org.gradle.api.provider.Property
import org.gradle.api.provider.Provider
import org.gradle.plugin.use.PluginDependency
import org.gradle.plugin.use.PluginDependencySpec

interface PluginsScope {
    fun alias(plugin: Provider<PluginDependency>): PluginDependencySpec
}

infix fun PluginDependencySpec.apply(apply: Boolean): PluginDependencySpec = apply(apply)

fun Project.plugins(block: PluginsScope.() -> Unit) = Unit

interface DependenciesScope {
    fun implementation(dependency: Any)

    fun debugImplementation(dependency: Any)

    fun testImplementation(dependency: Any)

    fun androidTestImplementation(dependency: Any)

    fun project(path: String): Any
}

fun Project.dependencies(block: DependenciesScope.() -> Unit) = Unit

/** `maven("…")` of Gradle's Kotlin DSL. */
fun RepositoryHandler.maven(
    url: Any,
    configure: org.gradle.api.artifacts.repositories.MavenArtifactRepository.() -> Unit,
) = Unit

/** `property = value` of Gradle's Kotlin DSL. */
fun <T : Any> Property<T>.assign(value: T) = set(value)
